#pragma once

#include "hardware/driver/DeviceDriver.h"

namespace asperity {

/// For mouse and keyboard themselves.
[[nodiscard]] const DeviceDriver& pointerDriver();

/// For the simulated haptic device, which mouse and keyboard pilot.
[[nodiscard]] const DeviceDriver& simulatedDriver();

}  // namespace asperity
