#pragma once

#include "core/haptics/DevicePath.h"

#include <utility>

namespace asperity {

/// Which place of the device stands for which place of the base, from one tick on.
struct DeviceMapping {
    Vector3 device = Vector3::Zero();  ///< of one tick [m]
    Vector3 base = Vector3::Zero();    ///< of the same one, world [m]
    double positionGain = 1.0;         ///< base displacement per device displacement

    /// Where the device must be for the base to be at `place` [m].
    [[nodiscard]] Vector3 deviceFor(const Vector3& place) const {
        return device + (place - base) / positionGain;
    }
};

/// Turns what mouse and keyboard ask for into a place for the device, once a frame.
class DevicePilot {
public:
    explicit DevicePilot(Vector3 start) : target_(std::move(start)) {}

    /// The mouse moved the device by so much [m]. Ends a journey.
    void displace(const Vector3& displacement);
    /// Keys are held that move the device so fast [m/s]. A velocity ends a journey.
    void setVelocity(const Vector3& velocity);
    /// The base shall go this way, world; also when the gain changes on the way.
    void follow(DevicePath journey);
    /// Where the device shall be now [m].
    [[nodiscard]] const Vector3& target() const noexcept { return target_; }
    [[nodiscard]] bool traveling() const noexcept { return !journey_.empty(); }

    /// Where the device shall be after a frame of so many seconds.
    Vector3 advance(double seconds, const DeviceMapping& mapping);

private:
    Vector3 target_;                      ///< [m]
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
    DevicePath journey_;
    double journeyTime_ = 0.0;  ///< [s]
};

}  // namespace asperity
