#pragma once

#include "core/Vector.h"
#include "core/scene/CouplingGains.h"

namespace asperity {

/// What contact and guide do to the proxy, as the last tick has it; world axes, the device's units.
struct ProxyLoad {
    Vector3 force = Vector3::Zero();    ///< all but friction [N]
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, unit
    double friction = 0.0;              ///< the most that it gives, >= 0 [N]
    double restSpeed = 1.0;             ///< v0, below which it fades [m/s], > 0
};

/// What one step makes; world axes, the device's units.
struct CouplingStep {
    Vector3 device = Vector3::Zero();   ///< force on the device [N]
    Vector3 motion = Vector3::Zero();   ///< of the proxy in this step [m]
    Vector3 stretch = Vector3::Zero();  ///< device less proxy at its end [m]
};

/// One step of the coupling. The force on the proxy is F = Kc (x - xp) + Bc (v - vp), the device
/// feels -F. The proxy has no mass: bp vp = F + load + friction. Position and velocity of the proxy
/// are those at the end of the step (backward Euler), so that the coupling itself is stable at any
/// rate and gain; only the force of the load is that of the last tick. At rest the operator feels
/// the load itself, without an error.
///
/// Friction, too, is that of the proxy's velocity at the end of the step, against it and of size
/// friction * |vp_t| / sqrt(|vp_t|^2 + v0^2) (docs/theory.md 6.2): that of the last tick would
/// throw a proxy at rest to and fro.
///
/// The device's velocity is v = deviceMotion / T of the positions as they were sampled, with
/// nothing smoothed: an encoder's step D then changes F by Bc D / T for one tick, whose impulse Bc
/// D is the same at any rate and moves a handle of mass m by Bc D / m a second. Source: Colgate,
/// Stanley, Brown (1995); Adams, Hannaford (1999); docs/haptics.md.
///
/// @param deviceMotion since the last step [m]
/// @param stretch    device less proxy at the end of the last step [m]
/// @param timeStep   T [s]
[[nodiscard]] CouplingStep stepCoupling(const CouplingGains& gains, const Vector3& deviceMotion,
                                        const Vector3& stretch, const ProxyLoad& load,
                                        double timeStep) noexcept;

}  // namespace asperity
