#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// Height of the tip's center at which a sphere that comes down along z above (x, y) first touches
/// the surface [m] (the gray-scale dilation of the surface by the tip). Global: every cell of the
/// spline under the sphere is searched unless its bound rules it out. For load time, not the tick.
/// Where no part of the scan lies under the sphere, the nearest edge point counts as under it.
/// @throw Error when the radius is not a positive length or the place is not finite
[[nodiscard]] double tipContactHeight(const BSplineSurface& surface, double x, double y,
                                      double tipRadius);

}  // namespace asperity
