#pragma once

#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/support/TestScenes.h"

#include <cmath>
#include <limits>

namespace asperity::test {

/// Level but for one hill near the upper left corner; twice as wide as high.
inline BSplineSurface wideSurface() {
    HeightMap map{.columns = 128, .rows = 64, .pitchX = 2.0_nm, .pitchY = 2.0_nm};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double distance = std::hypot(column - 16.0, row - 12.0);
            map.heights.push_back(10.0_nm * std::exp(-distance * distance / 40.0));
        }
    }
    return fitSurface(map);
}

/// Hills with the first rows and part of the left half without data.
inline HeightMap holedMap() {
    HeightMap map = hillyMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (row < 4 || (column < 20 && row > 20 && row < 40)) {
                map.heights[map.index(row, column)] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
    return map;
}

}  // namespace asperity::test
