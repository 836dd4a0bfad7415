#pragma once

#include "core/haptics/coupling/CouplingDesign.h"
#include "core/haptics/fixtures/VirtualFixture.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/TickInput.h"

namespace asperity {

/// State of the guide carried from tick to tick.
struct GuideMemory {
    VirtualFixture fixture;              ///< as the last tick's settings had it
    double positionGain = 0.0;           ///< same
    double share = 0.0;                  ///< of its force limit that acts, 0 to 1
    Vector3 velocity = Vector3::Zero();  ///< of the proxy, world axes, at the device [m/s]
};

/// Results of the guide in one tick; world axes, at the device.
struct GuideStep {
    Vector3 force = Vector3::Zero();  ///< on the proxy [N]
    double share = 0.0;               ///< of its force limit that acts
    bool changed = false;             ///< it is another guide, or lies elsewhere for the device
};

/// The guide of the settings as a load of the proxy. Its force limit comes on linearly in half a
/// second: one that is switched on, moved or zoomed away from the device holds energy that nobody
/// put in, and must not give it at once.
/// @param position     that the device commanded in the last tick, world [m]
[[nodiscard]] GuideStep stepGuide(const TickInput& input, const Vector3& position,
                                  const GuideMemory& memory) noexcept;

/// Returns the state that the next tick starts from.
/// @param motion of the proxy in this tick, world axes, at the device [m]
[[nodiscard]] GuideMemory guideAfter(const TickInput& input, const GuideStep& step,
                                     const Vector3& motion) noexcept;

/// State of the proxy carried from tick to tick; the proxy drives the base.
struct ProxyMemory {
    Vector3 stretch = Vector3::Zero();  ///< device less proxy, world axes, at the device [m]
    Vector3 load = Vector3::Zero();     ///< of the sample on the tip, all but friction [N]
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, unit
    double friction = 0.0;              ///< the most that it gives at the tip [N]
    CouplingGains gains;                ///< that the spring was stretched by
    double forceGain = 0.0;  ///< that the operator feels the sample with, on its way to the knob's
};

/// Results of one tick for the proxy.
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

/// Returns what the next tick starts from; a tip state without an equilibrium is no load.
/// @param correction slow part of estimate minus model [N]
[[nodiscard]] ProxyMemory proxyAfter(const TickInput& input, const ProxyStep& step,
                                     const TipState& state, const EquilibriumMemory& points,
                                     const Vector3& correction) noexcept;

}  // namespace asperity
