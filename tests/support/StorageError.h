#pragma once

#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <cmath>

namespace asperity::test {

/// How far a surface may lie off the one that was asked for because its control heights are
/// computed and kept in single precision.
struct StorageError {
    double height = 0.0;     ///< [m]
    double slope = 0.0;      ///< along either axis
    double curvature = 0.0;  ///< of any second derivative [1/m]
};

/// Rounding to 2^-24 of a height's distance from the datum happens to the map, whose error the fits
/// along x and y enlarge by up to 3 each, the sum of their weights' magnitudes; to what the fit
/// along x gives, which the other enlarges by up to 3; and at the end: 13 times in all, with the
/// sums 16. The weights of four control heights add up, in magnitude, to at most 1 for the
/// height, 1.5 per pitch for the slope and 4 per pitch squared for the second derivative.
inline StorageError storageErrorOf(const BSplineSurface& surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    float largest = 0.0F;
    for (const float control : grid.controlHeights) {
        largest = std::max(largest, std::abs(control));
    }
    const double pitch = std::min(grid.pitchX, grid.pitchY);
    const double height = 16.0 * std::ldexp(static_cast<double>(largest), -24);
    return {.height = height,
            .slope = 1.5 * height / pitch,
            .curvature = 4.0 * height / (pitch * pitch)};
}

}  // namespace asperity::test
