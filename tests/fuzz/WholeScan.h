#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <cstdlib>

namespace asperity {

/// Ends the program where a reader gives no channel, or one that is not whole.
/// @param source of the scan @throw InputError as readHeightMap()
inline void requireWhole(const StoredScan& scan, const ByteSource& source) {
    for (const StoredChannel& stored : scan.channels) {
        const HeightMap map = readHeightMap(stored, source);
        const bool isWhole = map.heights.size() == map.index(map.rows, 0) &&
                             (map.invalid.empty() || map.invalid.size() == map.heights.size());
        if (!isWhole) {
            std::abort();
        }
    }
    if (scan.channels.empty()) {
        std::abort();
    }
}

}  // namespace asperity
