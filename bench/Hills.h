#pragma once

#include "core/Random.h"

#include <cmath>

namespace asperity {

/// A map of hills of 10 nm from top to bottom with 0.1 nm of noise, 1 nm a pixel.
/// @tparam Map HeightMap or ScanMap
template <class Map>
Map hills(int pixels) {
    Map map;
    map.columns = pixels;
    map.rows = pixels;
    map.pitchX = 1e-9;
    map.pitchY = 1e-9;
    map.heights.resize(map.index(pixels, 0));
    Random random(3);
    for (int row = 0; row < pixels; ++row) {
        for (int column = 0; column < pixels; ++column) {
            const double hill = 5e-9 * std::sin(0.011 * column) * std::cos(0.013 * row);
            map.heights[map.index(row, column)] =
                static_cast<typename decltype(Map::heights)::value_type>(
                    hill + random.uniform(-1e-10, 1e-10));
        }
    }
    return map;
}

}  // namespace asperity
