#include "core/Error.h"
#include "core/io/HeightMapFormat.h"

#include <cstdint>
#include <cstdlib>

// One reader, whatever the bytes start with: it must give whole channels or throw an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const asperity::HeightMapFile file = asperity::ASPERITY_FUZZED.read(bytes, "fuzz");
        for (const asperity::ScanChannel& channel : file.channels) {
            const asperity::HeightMap& map = channel.map;
            const bool whole = map.heights.size() == map.index(map.rows, 0) &&
                               (map.invalid.empty() || map.invalid.size() == map.heights.size());
            if (!whole) {
                std::abort();
            }
        }
        if (file.channels.empty()) {
            std::abort();
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
