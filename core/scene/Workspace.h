#pragma once

#include "core/Vector.h"

namespace asperity {

/// The ball in which a device can be moved, and the spring that renders its edge; the device's axes
/// and units.
struct Workspace {
    Vector3 center = Vector3::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]; 0: not known, no spring
    double freeShare = 0.9;            ///< of the radius, up to which there is no spring
    double stiffness = 0.0;            ///< of the spring [N/m]
    double forceLimit = 0.0;           ///< of the spring, which nears it smoothly [N]

    bool operator==(const Workspace&) const = default;
};

}  // namespace asperity
