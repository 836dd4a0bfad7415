#pragma once

#include "core/haptics/device/DeviceStatus.h"

#include <string>

namespace asperity {

/// Advice for a user who may not open a device.
inline constexpr const char* kNoPermission =
    "no permission to open the device; install the udev rules 70-asperity-hid.rules and plug it in "
    "again";

/// Which device it is and what it waits for, or why there is none; empty for mouse and keyboard.
[[nodiscard]] std::string wordsOf(const DeviceStatus& status);

}  // namespace asperity
