#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// What holds of all control heights of a surface.
struct ControlBounds {
    double magnitude = 0.0;  ///< no control height lies farther from the datum [m]
    double concavity = 0.0;  ///< no valley is curved more strongly, >= 0 [1/m]
};

/// In one pass, two threads.
/// @throw Error when a control height is not finite
[[nodiscard]] ControlBounds controlBoundsOf(const BSplineSurface::Grid& grid);

}  // namespace asperity
