#include "core/io/ByteSource.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

std::string ByteSource::start(std::uint64_t most) const {
    std::string bytes(static_cast<std::size_t>(std::min(most, size())), '\0');
    read(0, bytes);
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
