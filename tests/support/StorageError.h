#pragma once

#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <cmath>

namespace asperity::test {

/// How far a surface may lie off the one that was fitted because its control heights are kept in
/// single precision.
struct StorageError {
    double height = 0.0;     ///< [m]
    double slope = 0.0;      ///< along either axis
    double curvature = 0.0;  ///< of any second derivative [1/m]
};

/// Each control height is off by at most 2^-24 of its distance from the datum. The weights of four
/// control heights add up, in magnitude, to at most 1 for the height, 1.5 per pitch for the slope
/// and 4 per pitch squared for the second derivative.
inline StorageError storageErrorOf(const BSplineSurface& surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    float largest = 0.0F;
    for (const float control : grid.controlHeights) {
        largest = std::max(largest, std::abs(control));
    }
    const double pitch = std::min(grid.pitchX, grid.pitchY);
    const double height = std::ldexp(static_cast<double>(largest), -24);
    return {.height = height,
            .slope = 1.5 * height / pitch,
            .curvature = 4.0 * height / (pitch * pitch)};
}

}  // namespace asperity::test
