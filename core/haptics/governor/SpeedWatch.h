#pragma once

#include "core/Vector.h"

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

}  // namespace asperity
