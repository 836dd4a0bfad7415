#pragma once

#include "core/haptics/coupling/VirtualCoupling.h"
#include "core/haptics/device/DeviceSpecification.h"

namespace asperity {

/// How old the force is with which the loop answers a motion.
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

/// Whether a coupling that was not designed keeps the same handle at rest: no stiffer and no more
/// damped than the device renders, and m s^2 + (Kc + Bc s) e^(-s tau) = 0 has its roots on the
/// left. That is so where the loop (Kc + Bc s) e^(-s tau) / (m s^2) has phase left at its one gain
/// of 1. Source: docs/haptics.md. @throw Error where a value of device or timing is no such thing
[[nodiscard]] bool holdsHandle(const CouplingGains& gains, const DeviceSpecification& device,
                               const LoopTiming& timing);

/// The stiffest contact, as seen from the device, that a proxy meets without gaining energy [N/m]:
/// the force is a tick old, and Colgate's bound b > K T / 2 holds for the proxy and its damper.
[[nodiscard]] double stiffestContact(const CouplingGains& gains, double timeStep) noexcept;

}  // namespace asperity
