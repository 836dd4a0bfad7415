#pragma once

#include "core/haptics/coupling/VirtualCoupling.h"

#include <optional>
#include <string>

namespace asperity {

/// How the hand's world and the tip's are scaled to each other.
struct HandScale {
    double positionGain = 1.0;  ///< displacement at the tip per displacement of the hand
    double forceGain = 1.0;     ///< force at the hand per force at the tip
};

/// What device and loop can bear.
struct StiffnessBounds {
    double device = 0.0;    ///< stiffness that the device renders [N/m]
    double timeStep = 0.0;  ///< from tick to tick [s]
};

/// A scale, judged.
struct ScaleJudgement {
    double contact = 0.0;       ///< stiffness of lever and contact, at the hand [N/m]
    double contactBound = 0.0;  ///< that the proxy meets without gaining energy [N/m]
    double felt = 0.0;          ///< stiffness in series with the coupling [N/m]
    double feltBound = 0.0;     ///< that the device renders [N/m]
    std::string sentence;       ///< for people: what is felt, or what is too stiff and the remedy

    [[nodiscard]] bool holds() const noexcept {
        return felt <= feltBound && contact <= contactBound;
    }
};

/// Stiffness of springs in series [N/m]; docs/physics.md 7.1.
[[nodiscard]] double inSeries(double first, double second) noexcept;

/// Judges the stiffness that the hand feels against the device's, and that of the contact against
/// what the proxy bears; without a coupling the hand feels the contact itself.
///
/// `tipStiffness` [N/m] is the largest that the tip meets: lever in series with the contact, along
/// the contact's normal. Before snap-in and pull-off the stiffness is negative and has no bound,
/// but it needs none: it only drives the proxy into the jump, which loses energy and ends on the
/// positive stiffness judged here. What the jump brings to the hand is a force, of at most the
/// adhesion, and it is the device's largest force that bounds that.
/// Source: docs/haptics.md.
[[nodiscard]] ScaleJudgement judgeScale(double tipStiffness, const HandScale& scale,
                                        const std::optional<CouplingGains>& coupling,
                                        const StiffnessBounds& bounds);

}  // namespace asperity
