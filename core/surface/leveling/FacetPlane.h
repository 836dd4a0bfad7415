#pragma once

#include "core/Progress.h"
#include "core/surface/leveling/PlaneFit.h"

namespace asperity {

/// The plane of the prevailing slope, relative to the map's datum; its height at the center of the
/// valid pixels is their mean.
///
/// That slope is Gwyddion's: the mean of the slopes of all squares of 2 x 2 valid pixels with the
/// weights exp(-d^2 / s^2), d being a square's distance from that mean and s^2 a twentieth of the
/// mean d^2. It is found, from a level plane on, to 1e-6 s. On flat tops and grounds with steps
/// between them it is the slope of the flats. Two threads, the same to the last bit on any number.
/// @throw Error when the map is unusable or no pixel is valid; Canceled
template <class Heights>
[[nodiscard]] PlaneFit facetPlane(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

}  // namespace asperity
