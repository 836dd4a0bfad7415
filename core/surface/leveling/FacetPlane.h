#pragma once

#include "core/Progress.h"
#include "core/surface/leveling/PlaneFit.h"

namespace asperity {

/// The plane of the prevailing slope, relative to the map's datum; its height at the center of the
/// valid pixels is their mean.
///
/// Gwyddion's facet leveling: of all squares of 2 x 2 valid pixels, the mean slope with the weights
/// exp(-d^2 / s^2), d being a square's distance from the last mean and s^2 a twentieth of the mean
/// d^2, repeated until the mean stays (to 1e-6 s; at most 100 times). On flat tops and grounds with
/// steps between them it is the slope of the flats. Two threads, the same to the last bit on any
/// number of them.
/// @throw Error when the map is unusable or no pixel is valid; Canceled
template <class Heights>
[[nodiscard]] PlaneFit facetPlane(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

}  // namespace asperity
