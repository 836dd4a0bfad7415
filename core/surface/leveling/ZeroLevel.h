#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

namespace asperity {

/// The lowest height of a valid pixel, relative to the map's datum [m].
/// @throw Error when the map is unusable or no pixel is valid; Canceled
template <class Heights>
[[nodiscard]] double lowestHeight(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

}  // namespace asperity
