#pragma once

#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>

namespace asperity::test {

/// A map of white noise, made smooth or left rough.
struct RoughMap {
    std::string name;
    int columns = 1;
    int rows = 1;
    double pitchX = 2.0_nm;  ///< [m]
    double pitchY = 2.0_nm;  ///< [m]
    double range = 0.0;      ///< between the lowest and the highest pixel, at most [m]
    double offset = 0.0;     ///< of all heights [m]
    double smoothing = 0.0;  ///< standard deviation of the low-pass [pixel]
    std::uint64_t seed = 11;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
inline void PrintTo(const RoughMap& rough, std::ostream* out) { *out << rough.name; }

inline HeightMap noisyMap(const RoughMap& rough) {
    HeightMap map = flatMap({.columns = rough.columns,
                             .rows = rough.rows,
                             .sizeX = rough.columns * rough.pitchX,
                             .sizeY = rough.rows * rough.pitchY});
    Random random(rough.seed);
    for (double& height : map.heights) {
        height = rough.offset + rough.range * random.uniform();
    }
    return map;
}

inline BSplineSurface surfaceOf(const RoughMap& rough) {
    return fitSurface(noisyMap(rough), {.x = rough.smoothing, .y = rough.smoothing});
}

/// A map whose pixel (row, column) is height(row, column).
template <class Height>
HeightMap mapOf(const ScanSize& size, const Height& height) {
    HeightMap map = flatMap(size);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = height(row, column);
        }
    }
    return map;
}

/// A position anywhere on the scan, its edge and the half pixel before it included.
inline Vector2 positionOn(const BSplineSurface& surface, Random& random) {
    return {random.uniform() * surface.sizeX(), random.uniform() * surface.sizeY()};
}

}  // namespace asperity::test
