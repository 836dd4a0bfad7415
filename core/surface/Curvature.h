#pragma once

#include "core/surface/HeightSample.h"

namespace asperity {

/// Principal curvatures of a surface at one place, positive for a bump [1/m].
struct PrincipalCurvatures {
    double largest = 0.0;   ///< [1/m]
    double smallest = 0.0;  ///< [1/m]
};

/// Source: docs/synthetic_surfaces.md 0 (mean and Gaussian curvature of a height field).
[[nodiscard]] PrincipalCurvatures principalCurvatures(const HeightSample& sample) noexcept;

}  // namespace asperity
