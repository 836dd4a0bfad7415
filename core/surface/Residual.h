#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

namespace asperity {

/// What smoothing took from a scan: data minus surface at every pixel center [m]. Pixels without
/// data have no residual either: they keep their mark and are not a number.
/// @param surface fitted to this map
/// @throw Error when the map is unusable or the surface has another size
[[nodiscard]] HeightMap residualOf(HeightMap map, const BSplineSurface& surface);
[[nodiscard]] ScanMap residualOf(ScanMap map, const BSplineSurface& surface);

}  // namespace asperity
