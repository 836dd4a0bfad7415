#include "core/haptics/device/HapticDevice.h"

namespace asperity {

void HapticDevice::setForce(const Vector3& /*force*/) noexcept {}

void HapticDevice::calibrate() noexcept {}

void HapticDevice::setSeenHalfWidth(double /*halfWidth*/) noexcept {}

}  // namespace asperity
