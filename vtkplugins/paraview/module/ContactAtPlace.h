#pragma once

#include "core/Vector.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <optional>

namespace asperity {

struct Scene;

/// Where the tip touches a scene; empty: decided by contactAt(). World frame.
struct ContactRequest {
    std::optional<Vector2> place;    ///< [m]; none: the middle of the scan
    std::optional<double> setpoint;  ///< force along z [N]; none: the scene's
    double halfWidth = 0.0;          ///< of the patch [m]; 0: four tip radii or five contacts wide
    int samples = 2;                 ///< of the patch, a side
};

/// A tip that has approached to a setpoint, by the believed model; world frame.
struct ContactAtPlace {
    TipState state;
    SurfacePatch patch;
    double halfWidth = 0.0;              ///< of the patch [m]
    RoundTip tip;                        ///< [m]
    RadialDisplacement tipDisplacement;  ///< into the tip, over the distance from the axis [m -> m]
    Vector3 contactPoint;                ///< middle of the contact on the deformed surface [m]
};

/// @throw Error when the place lies outside the scan, the setpoint is out of range, or the tip does
/// not come to it
[[nodiscard]] ContactAtPlace contactAt(const Scene& scene, const ContactRequest& request);

}  // namespace asperity
