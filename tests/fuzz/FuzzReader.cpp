#include "core/Error.h"
#include "core/io/heightmap/StoredRows.h"

#include <cstdint>
#include <cstdlib>

// One reader, whatever the bytes start with: it must give whole channels or throw an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const asperity::MemoryBytes source(bytes, "fuzz");
        const asperity::StoredScan scan = asperity::ASPERITY_FUZZED.read(source);
        for (const asperity::StoredChannel& stored : scan.channels) {
            const asperity::HeightMap map = asperity::readHeightMap(stored, source);
            const bool whole = map.heights.size() == map.index(map.rows, 0) &&
                               (map.invalid.empty() || map.invalid.size() == map.heights.size());
            if (!whole) {
                std::abort();
            }
        }
        if (scan.channels.empty()) {
            std::abort();
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
