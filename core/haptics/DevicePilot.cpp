#include "core/haptics/DevicePilot.h"

#include <utility>

namespace asperity {

void DevicePilot::displace(const Vector3& displacement) {
    journey_.clear();
    target_ += displacement;
}

void DevicePilot::setVelocity(const Vector3& velocity) {
    if (!velocity.isZero()) {
        journey_.clear();
    }
    velocity_ = velocity;
}

void DevicePilot::follow(DevicePath journey) {
    journey_ = std::move(journey);
    journeyTime_ = journey_.front().time;
}

Vector3 DevicePilot::advance(double seconds, const DeviceMapping& mapping) {
    target_ += seconds * velocity_;
    if (traveling()) {
        journeyTime_ += seconds;
        target_ = mapping.deviceFor(positionAt(journey_, journeyTime_));
        if (journeyTime_ >= journey_.back().time) {
            journey_.clear();
        }
    }
    return target_;
}

}  // namespace asperity
