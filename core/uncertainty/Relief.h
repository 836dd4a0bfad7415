#pragma once

#include "core/surface/HeightSample.h"

#include <Eigen/Core>

namespace asperity {

/// Slopes and second derivatives of a surface at one place: dx, dy, dxx, dxy, dyy.
using Relief = Eigen::Matrix<double, 5, 1>;

[[nodiscard]] inline Relief reliefOf(const HeightSample& sample) noexcept {
    return {sample.dx, sample.dy, sample.dxx, sample.dxy, sample.dyy};
}

/// A sample with these derivatives, at height 0.
[[nodiscard]] inline HeightSample sampleOf(const Relief& relief) noexcept {
    return {.dx = relief[0], .dy = relief[1], .dxx = relief[2], .dxy = relief[3], .dyy = relief[4]};
}

}  // namespace asperity
