#pragma once

#include "core/surface/RoundTip.h"

namespace asperity {

/// Outline of a tip as it is drawn, see vtkAspTipSource: with a shank, and perhaps as a paraboloid.
struct TipOutline {
    RoundTip tip;
    double paraboloidReach = 0.0;  ///< see ViewScale [m]

    /// Distance of the outline from the axis at a height above the apex, >= 0 [m].
    [[nodiscard]] double radius(double height) const;
    /// Half the width of a frame around a tip that is pressed in so deep: none of it leaves the
    /// block of sample through a side [m]. A tip that does not touch needs none.
    [[nodiscard]] double frameAround(double indentation) const;
};

}  // namespace asperity
