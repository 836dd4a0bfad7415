#include "core/io/ByteSource.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

std::string ByteSource::start(std::uint64_t most) const {
    std::string bytes(static_cast<std::size_t>(std::min(most, size())), '\0');
    read(0, bytes);
    return bytes;
}

std::string ByteSource::startUntil(const std::function<bool(std::string_view)>& areEnough,
                                   std::uint64_t most) const {
    constexpr std::size_t kFirst = std::size_t{1} << 14U;
    const auto last = static_cast<std::size_t>(std::min(most, size()));
    std::string bytes = start(std::min(kFirst, last));
    while (bytes.size() < last && !areEnough(bytes)) {
        const std::size_t before = bytes.size();
        bytes.resize(std::min(2 * before, last));
        read(before, std::span(bytes).subspan(before));
    }
    return bytes;
}

void MemoryBytes::read(std::uint64_t place, std::span<char> bytes) const {
    if (place > bytes_.size() || bytes.size() > bytes_.size() - place) {
        throw InputError(name(), "byte " + std::to_string(bytes_.size()),
                         "the content ends here; it is truncated or damaged");
    }
    std::ranges::copy(bytes_.substr(static_cast<std::size_t>(place), bytes.size()), bytes.begin());
}

}  // namespace asperity
