#pragma once

namespace asperity {

/// The maker's specification of a haptic device; a value of 0: not known, or it has none.
struct DeviceSpecification {
    double maxForce = 0.0;         ///< that its motors render [N]; 0: it only senses
    double maxStiffness = 0.0;     ///< that it renders [N/m]
    double maxDamping = 0.0;       ///< that it renders [N s/m]
    double effectiveMass = 0.0;    ///< of the handle [kg]
    double workspaceRadius = 0.0;  ///< of the ball about its zero in which the handle moves [m]
    bool streams = false;          ///< it reports all the time: that it falls silent is a fault
    bool calibrates = false;       ///< HapticDevice::calibrate() says where it is

    [[nodiscard]] bool rendersForce() const noexcept { return maxForce > 0.0; }
};

}  // namespace asperity
