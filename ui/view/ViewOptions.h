#pragma once

#include "core/Vector.h"

namespace asperity {

/// Where the light of a view comes from, as seen on the screen; it goes with the eye.
struct Light {
    double azimuth = 132.0;   ///< counterclockwise from rightwards [degree]
    double elevation = 24.0;  ///< above the screen's plane, to the eye [degree]

    /// Unit vector: rightwards, upwards, to the eye.
    [[nodiscard]] Vector3 direction() const;

    bool operator==(const Light&) const = default;
};

inline constexpr double kMaxHeightScale = 1000.0;

/// What a user switches in a view.
struct ViewOptions {
    double heightScale = 1.0;  ///< of all that is upright, 1 .. kMaxHeightScale
    bool axes = true;
    bool scaleBars = true;
    bool grid = true;
    bool labels = true;         ///< values, names and notes: without them pictures are exported
    bool deformation = true;    ///< the surface moves under the tip; else it is drawn at rest
    bool section = false;       ///< the half before the tip is cut away
    bool commandedTip = false;  ///< ghost of the tip where it would be without forces
    bool trueTip = false;       ///< ghost of the tip where a simulated instrument has it
    Light light;

    bool operator==(const ViewOptions&) const = default;
};

}  // namespace asperity
