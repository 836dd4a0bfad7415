#pragma once

#include "core/Vector.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <optional>

namespace asperity {

struct Scene;

/// Position and setpoint of a contact on a scene; empty: decided by contactAt(). World frame.
struct ContactRequest {
    std::optional<Vector2> position;  ///< [m]; none: the middle of the scan
    std::optional<double> setpoint;   ///< force along z [N]; none: the scene's
    double halfWidth = 0.0;           ///< of the patch [m]; 0: four tip radii or five contacts wide
    int samples = 2;                  ///< of the patch, a side
};

/// A tip that has approached to a setpoint, by the believed model; world frame.
struct LocalContact {
    TipState state;
    SurfacePatch patch;
    double halfWidth = 0.0;              ///< of the patch [m]
    RoundTip tip;                        ///< [m]
    RadialDisplacement tipDisplacement;  ///< into the tip, over the distance from the axis [m -> m]
    Vector3 contactPoint;                ///< middle of the contact on the deformed surface [m]
};

/// @throw Error when the position lies outside the scan, the setpoint is out of range, or the tip
/// does not come to it
[[nodiscard]] LocalContact contactAt(const Scene& scene, const ContactRequest& request);

}  // namespace asperity
