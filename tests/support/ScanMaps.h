#pragma once

#include "core/surface/HeightMap.h"

namespace asperity::test {

/// The map in single precision, about the middle of its heights.
/// @throw Error when the map is unusable, or its heights lie too far apart for single precision
[[nodiscard]] inline ScanMap singlePrecision(const HeightMap& map) {
    requireUsable(map);
    ScanMap result;
    result.columns = map.columns;
    result.rows = map.rows;
    result.pitchX = map.pitchX;
    result.pitchY = map.pitchY;
    result.datum = middleHeight(map);
    result.heights.reserve(map.heights.size());
    for (const double height : map.heights) {
        result.heights.push_back(static_cast<float>(height - result.datum));
    }
    result.invalid = map.invalid;
    return result;
}

}  // namespace asperity::test
