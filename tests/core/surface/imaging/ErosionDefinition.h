#pragma once

#include "core/surface/HeightMap.h"
#include "tests/support/DoubleLimits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::test {

/// R - sqrt(R^2 - d^2), infinite beyond the tip.
inline double riseOf(const HeightMap& map, int rows, int columns, double tip) {
    const double d = std::hypot(columns * map.pitchX, rows * map.pitchY);
    return d > tip ? std::numeric_limits<double>::infinity()
                   : d * (d / (tip + std::sqrt((tip - d) * (tip + d))));
}

template <class Visit>
void forEachPixel(const HeightMap& map, const Visit& visit) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            visit(row, column);
        }
    }
}

/// The definition, pixel by pixel; plus infinity where no valid pixel is in reach.
inline double erosionAt(const HeightMap& image, int row, int column, double tip) {
    double lowest = std::numeric_limits<double>::infinity();
    forEachPixel(image, [&](int r, int c) {
        if (image.isValid(r, c) && isFiniteHeight(image.at(r, c))) {
            lowest = std::min(lowest, image.at(r, c) + riseOf(image, r - row, c - column, tip));
        }
    });
    return lowest;
}

/// Whether the tip over a pixel lies over the map as a whole.
inline bool tipIsWithin(const HeightMap& map, int row, int column, double tip) {
    const double x = std::floor(tip / map.pitchX);
    const double y = std::floor(tip / map.pitchY);
    return std::min(row, map.rows - 1 - row) >= y &&
           std::min(column, map.columns - 1 - column) >= x;
}

}  // namespace asperity::test
