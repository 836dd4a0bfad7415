#pragma once

#include "core/haptics/coupling/TipLoad.h"
#include "core/haptics/coupling/VirtualCoupling.h"

#include <optional>

namespace asperity {

/// How the device's world and the tip's are scaled to each other.
struct DeviceScale {
    double positionGain = 1.0;  ///< displacement at the tip per displacement of the device
    double forceGain = 1.0;     ///< device force per force at the tip

    bool operator==(const DeviceScale&) const = default;
};

/// A guide (virtual fixture) that pulls at the proxy beside the contact, at the device's scale.
struct GuideLoad {
    double stiffness = 0.0;  ///< k [N/m]
    double damping = 0.0;    ///< b [N s/m]
};

/// What device and loop can bear.
struct ScaleBounds {
    double stiffness = 0.0;  ///< that the device renders [N/m]
    double force = 0.0;      ///< that its motors may give [N]
    double timeStep = 0.0;   ///< from tick to tick [s]
};

/// A scale, judged.
struct ScaleJudgment {
    double contact = 0.0;       ///< stiffness of lever and contact, at the device [N/m]
    double contactBound = 0.0;  ///< that the proxy meets without gaining energy [N/m]
    double felt = 0.0;          ///< stiffness in series with the coupling [N/m]
    double feltBound = 0.0;     ///< that the device renders [N/m]
    double adhesion = 0.0;      ///< of the sample, at the device [N]
    double forceBound = 0.0;    ///< that the motors may give [N]
    bool guided = false;        ///< a guide takes its part of `contactBound`

    [[nodiscard]] bool holds() const noexcept {
        return felt <= feltBound && contact <= contactBound && adhesion <= forceBound;
    }
};

/// Judges three things; without a coupling the operator feels the contact itself, and no guide
/// acts:
///
/// - the stiffness that the operator feels against what the device renders;
/// - the contact K that the proxy meets, with the guide beside it: (K + k) T/2 + b must stay below
///   bp, for the force of both is a tick old;
/// - the adhesion against what the motors may give: one that pulls harder is not held, the handle
///   gives way with the force at its limit.
///
/// Before snap-in and pull-off the stiffness is negative and has no bound, but it needs none: it
/// only drives the proxy into the jump, which loses energy and ends on the positive stiffness
/// judged here. What the jump brings to the device is a force, of at most the adhesion.
/// Source: docs/haptics.md.
[[nodiscard]] ScaleJudgment judgeScale(const TipLoad& tip, const DeviceScale& scale,
                                       const std::optional<CouplingGains>& coupling,
                                       const ScaleBounds& bounds, const GuideLoad& guide = {});

}  // namespace asperity
