#include "core/haptics/device/HapticDevice.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kResponse = 50.0;  // natural frequency of the follower [rad/s]

}  // namespace

PilotedDevice::PilotedDevice(const Vector3& start)
    : start_(start), target_(start), position_(start) {}

// The exact solution of x'' = w^2 (target - x) - 2 w x' over one step: stable at any step.
const Vector3& PilotedDevice::pilot(double timeStep) noexcept {
    const Vector3& target = target_.read();
    const double decay = std::exp(-kResponse * timeStep);
    const Vector3 error = position_ - target;
    const Vector3 drive = velocity_ + kResponse * error;
    position_ = target + decay * (error + timeStep * drive);
    velocity_ = decay * (velocity_ - kResponse * timeStep * drive);
    return position_;
}

}  // namespace asperity
