#pragma once

#include "core/haptics/coupling/CouplingDesign.h"
#include "core/haptics/coupling/ScaleGuard.h"
#include "core/haptics/device/DeviceSpecification.h"

#include <string>

namespace asperity {

/// A force-feedback device that shall drive a tip.
struct DeviceRequest {
    DeviceSpecification device;
    LoopTiming timing;
    DeviceScale scale;
    CouplingGains own;      ///< that the scene asks for; none: those that are designed
    double maxForce = 0.0;  ///< that the operator shall feel at most [N]
    GuideLoad guide;
    PositionControl control = PositionControl::Base;
};

/// The coupling of such a device, and what it feels; or why there is none.
struct CoupledDevice {
    CouplingGains gains;
    ScaleJudgment judgment;
    std::string noCoupling;  ///< why designCoupling() has none; empty: it has

    [[nodiscard]] bool holds() const noexcept { return noCoupling.empty() && judgment.holds(); }
};

/// The scene's own coupling where it keeps the handle at rest and bears the contact, else the
/// designed one where that does: a force-feedback device is never without.
/// Source: docs/haptics.md, Gains and Scale.
[[nodiscard]] CoupledDevice coupleDevice(const ProbeSystem& tip, const DeviceRequest& request);

}  // namespace asperity
