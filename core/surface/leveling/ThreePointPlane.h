#pragma once

#include "core/surface/leveling/LevelingStep.h"
#include "core/surface/leveling/PlaneFit.h"

namespace asperity {

/// The plane through the heights at three places, relative to the map's datum. A place stands for
/// the valid pixels among the 3 x 3 around it: their mean height at the mean of their centers, so
/// that the plane of a tilted plane is that plane.
/// @throw Error when a place lies outside the scan or has no valid pixel, or all three are on a
/// line
///        within a pixel
template <class Heights>
[[nodiscard]] PlaneFit threePointPlane(const BasicHeightMap<Heights>& map,
                                       const LevelPoints& points);

}  // namespace asperity
