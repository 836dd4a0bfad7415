#pragma once

#include "core/Vector.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

#include <cstdint>

namespace asperity {

/// Measures how fast a device moves over stretches of two milliseconds, or one tick where that is
/// longer: a device reports less often than a fast loop ticks, and from tick to tick its position
/// would stand still and leap.
struct SpeedWatch {
    Vector3 from = Vector3::Zero();  ///< where the present stretch began [m]
    double time = 0.0;               ///< since then [s]
    bool started = false;            ///< false: nothing is known of the device yet
    double speed = 0.0;              ///< over the last whole stretch [m/s]
};

/// The watch after one more time step [s], with the device at `position` [m]. Both finite.
[[nodiscard]] SpeedWatch watchSpeed(const SpeedWatch& watch, const Vector3& position,
                                    double timeStep) noexcept;

/// A device may be silent for this long; then its force begins to fade [s].
inline constexpr double kSilenceAllowed = 10e-3;
/// Here it has faded, which is a fault: one period of the slowest tick before the 50 ms at which it
/// must be gone [s].
inline constexpr double kSilenceEnd = 40e-3;
/// Share of the largest force up to which a force may come on.
inline constexpr double kSmallShare = 0.1;

/// Force that a tick requests for the operator; the device's axes.
struct ForceRequest {
    Vector3 force = Vector3::Zero();  ///< of the coupling, or of the sample itself [N]
    double mismatch = 0.0;            ///< Kc |device less proxy|, 0 without a coupling [N]
    Vector3 edge = Vector3::Zero();   ///< of the device's workspace, which a clutch leaves [N]
    Fault fault = Fault::None;        ///< latched before, or found by this tick
};

/// State of the governor carried from tick to tick.
struct GovernorMemory {
    double share = 0.0;        ///< of the wanted force that acts, 0 to 1
    double edgeShare = 0.0;    ///< same of the edge's
    std::uint32_t starts = 0;  ///< as the last tick had them
    SpeedWatch speed;          ///< of the device
};

struct GovernedForce {
    Vector3 force = Vector3::Zero();  ///< for the device, its axes [N]
    ForceState state = ForceState::Off;
    Fault fault = Fault::None;  ///< that of the request, or the first that the governor found
    GovernorMemory memory;
};

/// The last step between the tick and a device that renders force. In order: values that are not
/// finite; saturation, which keeps the direction; the force comes on, linearly in engageTime, once
/// it is small (kSmallShare), the proxy near the device and the device slow; dead-man switch;
/// watchdog on the age of the device's newest report; velocity trip, while the force acts. A fault,
/// a released switch, a start and forces off take the force away in the same tick, and it comes on
/// again afterwards; a clutch does so to all but the force of the workspace's edge. In normal
/// running the wanted force passes unchanged: nothing is smoothed. A device that only senses gets
/// its force as wanted, or none. Source: docs/haptics.md, Governor.
[[nodiscard]] GovernedForce governForce(const TickInput& input, const ForceRequest& request,
                                        const GovernorMemory& before) noexcept;

}  // namespace asperity
