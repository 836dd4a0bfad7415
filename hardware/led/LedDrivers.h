#pragma once

#include "hardware/driver/DeviceDriver.h"

namespace asperity {

/// For mouse and keyboard, which need no device.
[[nodiscard]] const DeviceDriver& pointerDriver();

/// For a haptic device without the device, which mouse and keyboard lead.
[[nodiscard]] const DeviceDriver& simulatedDriver();

}  // namespace asperity
