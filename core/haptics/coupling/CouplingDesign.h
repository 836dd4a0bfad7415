#pragma once

#include "core/Vector.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/Settings.h"

#include <optional>

namespace asperity {

/// Load of contact and guide on the proxy, as of the last tick; world axes, the device's units.
struct ProxyLoad {
    Vector3 force = Vector3::Zero();    ///< all but friction [N]
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, unit
    double friction = 0.0;              ///< the most that it gives, >= 0 [N]
    double restSpeed = 1.0;             ///< v0, below which it fades [m/s], > 0
};

/// Results of one step; world axes, the device's units.
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

/// Timing of the loop, by which the force that answers a motion is late.
struct LoopTiming {
    double timeStep = 1e-3;  ///< T, from tick to tick [s]
    double delay = 0.0;      ///< t_d, as measured from a motion to its force, without the hold [s]
};

inline constexpr double kMinCouplingStiffness = 250.0;  ///< softer couplings hide the surface [N/m]

/// Gains with which a handle of the given mass stays at rest whatever the proxy touches and
/// however it is held, even not at all. With tau = T/2 + t_d, the age of the force:
///
/// - Kc, the stiffest of: what the device renders; 600 N/m, the stiffest shown; m / (6 tau^2), a
///   third of the stiffness (0.549 m / tau^2) at which no damping holds a late spring any more.
/// - Bc = Kc tau + 2 * 0.15 sqrt(Kc m): the delay takes Kc tau of damping away (Colgate's bound);
///   what is left is 0.15 of the critical damping. Where the device cannot render it, Kc is less.
/// - bp = 3 N s/m, a drag of 0.3 N at 0.1 m/s. It bounds the contact, see stiffestContact().
///
/// A mass that is not known is taken as 0.045 kg, that of the lightest desktop devices.
/// Source: Colgate, Schenkel (1997); docs/haptics.md.
/// @throw Error where that is softer than kMinCouplingStiffness, or a value is no such thing
[[nodiscard]] CouplingGains designCoupling(const DeviceSpecification& device,
                                           const LoopTiming& timing);

/// Returns whether a coupling that was not designed keeps the same handle at rest: no stiffer and
/// no more damped than the device renders, and m s^2 + (Kc + Bc s) e^(-s tau) = 0 has its roots on
/// the left. That is so where the loop (Kc + Bc s) e^(-s tau) / (m s^2) has phase left at its one
/// gain of 1. Source: docs/haptics.md. @throw Error where a value of device or timing is no such
/// thing
[[nodiscard]] bool holdsHandle(const CouplingGains& gains, const DeviceSpecification& device,
                               const LoopTiming& timing);

/// The stiffest contact, as seen from the device, that a proxy meets without gaining energy [N/m]:
/// the force is a tick old, and Colgate's bound b > K T / 2 holds for the proxy and its damper.
[[nodiscard]] double stiffestContact(const CouplingGains& gains, double timeStep) noexcept;

/// The worst that a tip meets on its sample.
struct TipLoad {
    double stiffness = 0.0;  ///< largest, of the lever in series with the contact [N/m]
    double adhesion = 0.0;   ///< by which the sample holds the tip back, at most, >= 0 [N]
};

/// Stiffness of springs in series [N/m]; docs/theory.md 7.1.
[[nodiscard]] double inSeries(double first, double second) noexcept;

/// Along the normal of a flat sample. With the tip under control the base makes up for the lever,
/// and the device meets the contact alone. A contact stiffens as it is pressed, so that its
/// stiffness is that under `largestForce` [N]; the adhesion is the pull-off force of the contact
/// law, under a load that does not give way, with a meniscus where there is one. Source:
/// docs/haptics.md.
[[nodiscard]] TipLoad tipLoad(const ProbeSystem& system, double largestForce,
                              PositionControl control = PositionControl::Base) noexcept;

/// Scaling between the device's world and the tip's.
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

/// Limits of what device and loop can bear.
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
