#pragma once

#include "core/haptics/Guide.h"
#include "core/haptics/coupling/VirtualCoupling.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/TickInput.h"

namespace asperity {

/// What one tick hands to the next about the proxy, which leads the base in the hand's place.
struct ProxyMemory {
    Vector3 stretch = Vector3::Zero();  ///< hand less proxy, world axes, at the hand [m]
    Vector3 load = Vector3::Zero();     ///< of the sample on the tip, all but friction [N]
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, unit
    double friction = 0.0;              ///< the most that it gives at the tip [N]
    CouplingGains gains;                ///< that the spring was stretched by
    double forceGain = 0.0;             ///< likewise
};

/// Moves the proxy in one tick; without a coupling it goes with the hand and there is no force. A
/// force gain, coupling or guide that changed seats the spring so that it just bears the load:
/// nothing moves by itself, and the hand feels the load at its new scale.
/// @param handMotion in this tick, world axes, at the hand [m]
[[nodiscard]] CouplingStep moveProxy(const TickInput& input, const Vector3& handMotion,
                                     const GuideStep& guide, const ProxyMemory& memory) noexcept;

/// What the next tick starts from; a state without an equilibrium is no load.
/// @param correction slow part of estimate minus model [N]
[[nodiscard]] ProxyMemory proxyAfter(const TickInput& input, const CouplingStep& step,
                                     const TipState& state, const EquilibriumMemory& feet,
                                     const Vector3& correction) noexcept;

}  // namespace asperity
