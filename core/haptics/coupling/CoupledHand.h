#pragma once

#include "core/haptics/coupling/CouplingDesign.h"
#include "core/haptics/coupling/ScaleGuard.h"
#include "core/haptics/device/DeviceSpecification.h"

#include <string>

namespace asperity {

/// A device with motors that shall lead a tip.
struct HandRequest {
    DeviceSpecification device;
    LoopTiming timing;
    HandScale scale;
    CouplingGains own;      ///< that the scene asks for; none: those that are designed
    double maxForce = 0.0;  ///< that the hand shall feel at most [N]
    GuideLoad guide;
    PositionControl control = PositionControl::Base;
};

/// The coupling of such a hand, and what it feels; or why there is none.
struct CoupledHand {
    CouplingGains gains;
    ScaleJudgment judgment;
    std::string refusal;  ///< one sentence with the numbers; empty: it holds

    [[nodiscard]] bool holds() const noexcept { return refusal.empty(); }
};

/// The scene's own coupling where it keeps the handle at rest and bears the contact, else the
/// designed one where that does: a hand with motors is never without.
/// Source: docs/haptics.md, Gains and Scale.
[[nodiscard]] CoupledHand coupleHand(const ProbeSystem& tip, const HandRequest& request);

}  // namespace asperity
