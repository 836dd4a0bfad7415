#pragma once

namespace asperity {

/// In place of a button's number: there is none.
inline constexpr int kNoButton = -1;
inline constexpr int kLastButton = 31;

/// What the force governor holds a rendered force to. Source: docs/haptics.md.
struct GovernorLimits {
    double maxForce = 3.0;          ///< the most that the operator shall feel [N]
    double engageTime = 1.0;        ///< in which the force comes on [s], > 0
    double maxDeviceSpeed = 1.5;    ///< above it the device runs away [m/s]
    int deadManButton = kNoButton;  ///< bit of DeviceState::buttons that must be held

    bool operator==(const GovernorLimits&) const = default;
};

}  // namespace asperity
