#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// A place on the surface, world frame.
struct SurfacePlace {
    double x = 0.0;       ///< [m]
    double y = 0.0;       ///< [m]
    double height = 0.0;  ///< of the surface there [m]
};

/// The highest place that is farther from each edge than `marginFraction` (0 to 0.5) of the scan:
/// of those at which the scan holds data, if there are any.
/// @throw Error when the margin is outside that range
[[nodiscard]] SurfacePlace highestPlace(const BSplineSurface& surface, double marginFraction);

}  // namespace asperity
