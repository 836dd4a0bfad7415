#pragma once

#include "core/Vector.h"

#include <cmath>

namespace asperity {

/// Height of a surface and its derivatives at one position of the world frame.
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

/// Principal curvatures of a surface at one position, positive for a bump [1/m].
struct PrincipalCurvatures {
    double largest = 0.0;   ///< [1/m]
    double smallest = 0.0;  ///< [1/m]
};

/// Source: docs/synthetic_surfaces.md 0 (mean and Gaussian curvature of a height field).
[[nodiscard]] PrincipalCurvatures principalCurvatures(const HeightSample& sample) noexcept;

}  // namespace asperity
