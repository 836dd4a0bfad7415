#include "core/io/heightmap/Hdf5Names.h"

#include "core/io/ByteReader.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace asperity {

using namespace std::string_view_literals;

bool isHdf5(const ByteSource& bytes) { return bytes.startsWith("\x89HDF\r\n\x1A\n"sv); }

bool holdsName(const ByteSource& bytes, std::string_view name) {
    constexpr std::uint64_t kChunk = std::uint64_t{1} << 20U;
    constexpr std::uint64_t kOverlap = 64;
    for (std::uint64_t place = 0; place < bytes.size(); place += kChunk - kOverlap) {
        const std::string chunk = bytesOf(bytes, {place, std::min(kChunk, bytes.size() - place)});
        if (chunk.find(name) != std::string::npos) {
            return true;
        }
    }
    return false;
}

}  // namespace asperity
