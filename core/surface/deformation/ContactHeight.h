#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// Height of the tip's center at which a sphere that comes down along z above (x, y) first touches
/// the surface [m] (the gray-scale dilation of the surface by the tip). Global: every cell of the
/// spline under the sphere is searched unless its bound rules it out. For load time, not the tick.
/// If no part of the scan lies under the sphere, the nearest edge point counts as under it.
/// @throw Error when the radius is not a positive length or the position is not finite
[[nodiscard]] double tipContactHeight(const BSplineSurface& surface, double x, double y,
                                      double tipRadius);

/// A position on the surface, world frame.
struct SurfacePoint {
    double x = 0.0;       ///< [m]
    double y = 0.0;       ///< [m]
    double height = 0.0;  ///< of the surface there [m]
};

/// The highest position that is farther from each edge than `marginFraction` (0 to 0.5) of the
/// scan: of those at which the scan holds data, if there are any.
/// @throw Error when the margin is outside that range
[[nodiscard]] SurfacePoint highestPoint(const BSplineSurface& surface, double marginFraction);

}  // namespace asperity
