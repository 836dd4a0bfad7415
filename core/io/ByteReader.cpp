#include "core/io/ByteReader.h"

#include "core/Error.h"

namespace asperity {

std::string_view ByteReader::take(std::uint64_t count, std::string_view what) {
    if (count > remaining()) {
        fail("expected " + std::to_string(count) + " bytes of " + std::string(what) +
             ", but only " + std::to_string(remaining()) +
             " are left; the file is truncated or damaged");
    }
    const std::string_view taken = bytes_.substr(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
}

std::string_view ByteReader::takeString(std::string_view what) {
    const std::size_t end = bytes_.find('\0', position_);
    if (end == std::string_view::npos) {
        fail("expected " + std::string(what) +
             " that ends with a NUL byte; the file is truncated or damaged");
    }
    const std::string_view taken = bytes_.substr(position_, end - position_);
    position_ = end + 1;
    return taken;
}

void ByteReader::fail(std::string_view message) const {
    throw InputError(std::string(file_), "byte " + std::to_string(place()), std::string(message));
}

}  // namespace asperity
