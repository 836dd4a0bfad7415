#pragma once

#include "core/haptics/Guide.h"
#include "core/haptics/coupling/VirtualCoupling.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/TickInput.h"

namespace asperity {

/// What one tick hands to the next about the proxy, which drives the base in the device's place.
struct ProxyMemory {
    Vector3 stretch = Vector3::Zero();  ///< device less proxy, world axes, at the device [m]
    Vector3 load = Vector3::Zero();     ///< of the sample on the tip, all but friction [N]
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, unit
    double friction = 0.0;              ///< the most that it gives at the tip [N]
    CouplingGains gains;                ///< that the spring was stretched by
    double forceGain = 0.0;  ///< that the operator feels the sample with, on its way to the knob's
};

/// What one tick makes of the proxy.
struct ProxyStep {
    CouplingStep coupling;
    double forceGain = 0.0;  ///< in this tick
};

/// Moves the proxy in one tick; without a coupling it goes with the device and there is no force. A
/// coupling or guide that changed seats the spring so that it just bears the load: nothing moves by
/// itself. A force gain that changed is neared by a factor of e in 0.1 s, and the spring with it,
/// so that the force neither steps nor moves anything.
/// @param deviceMotion in this tick, world axes, at the device [m]
[[nodiscard]] ProxyStep moveProxy(const TickInput& input, const Vector3& deviceMotion,
                                  const GuideStep& guide, const ProxyMemory& memory) noexcept;

/// What the next tick starts from; a state without an equilibrium is no load.
/// @param correction slow part of estimate minus model [N]
[[nodiscard]] ProxyMemory proxyAfter(const TickInput& input, const ProxyStep& step,
                                     const TipState& state, const EquilibriumMemory& points,
                                     const Vector3& correction) noexcept;

}  // namespace asperity
