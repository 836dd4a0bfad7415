#pragma once

#include "core/surface/HeightMap.h"

namespace asperity {

/// Widest low-pass that is offered [pixel]: what is left of a scan beyond it is no surface.
inline constexpr double kWidestSmoothing = 100.0;

/// The map after a Gaussian low-pass with a standard deviation of `sigmaPixels` along both axes.
///
/// Beyond its borders the map is continued by point reflection about the border pixel, so that a
/// plane comes back unchanged. The kernel is cut off at 5 standard deviations. 0: unchanged.
/// @throw Error when the map is unusable, a height is not finite, or `sigmaPixels` is not in
///        0..kWidestSmoothing
[[nodiscard]] HeightMap smoothed(const HeightMap& map, double sigmaPixels);

}  // namespace asperity
