#pragma once

#include "core/Vector.h"

#include <cmath>

namespace asperity {

/// Height of a surface and its derivatives at one place of the world frame.
struct HeightSample {
    double height = 0.0;  ///< [m]
    double dx = 0.0;      ///< slope along x
    double dy = 0.0;      ///< slope along y
    double dxx = 0.0;     ///< [1/m]
    double dxy = 0.0;     ///< [1/m]
    double dyy = 0.0;     ///< [1/m]

    /// Sum of the magnitudes of the second derivatives [1/m].
    [[nodiscard]] double bend() const noexcept {
        return std::abs(dxx) + std::abs(dxy) + std::abs(dyy);
    }

    /// Unit normal, pointing out of the sample.
    [[nodiscard]] Vector3 normal() const noexcept { return Vector3(-dx, -dy, 1.0).normalized(); }
};

}  // namespace asperity
