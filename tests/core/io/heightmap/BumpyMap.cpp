#include "tests/core/io/heightmap/BumpyMap.h"

#include <cmath>
#include <limits>

namespace asperity::test {

HeightMap bumpyMap(int columns, int rows) {
    HeightMap map;
    map.columns = columns;
    map.rows = rows;
    map.pitchX = 3e-9;
    map.pitchY = 5e-9;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights.push_back(2e-8 * std::sin(1.3 * column) + 1e-8 * std::cos(0.7 * row) +
                                  1e-9 * column);
        }
    }
    return map;
}

HeightMap bumpyMapWithHoles(int columns, int rows) {
    HeightMap map = bumpyMap(columns, rows);
    map.invalid.assign(map.heights.size(), 0);
    for (const std::size_t pixel : {0U, 4U}) {
        map.invalid[pixel] = 1;
        map.heights[pixel] = std::numeric_limits<double>::quiet_NaN();
    }
    return map;
}

}  // namespace asperity::test
