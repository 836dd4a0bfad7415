#pragma once

#include "core/haptics/coupling/CouplingKeeper.h"
#include "core/haptics/device/HapticDevice.h"

#include <string>

namespace asperity {

/// Advice for a user who may not open a device.
inline constexpr const char* kNoPermission =
    "no permission to open the device; install the udev rules 70-asperity-hid.rules and plug it in "
    "again";

/// Returns which device it is and what it waits for, or why there is none; empty for mouse and
/// keyboard.
[[nodiscard]] std::string wordsOf(const DeviceStatus& status);

/// "1 mm : 1 nm, 1 N : 10 nN; stiffness at the device 247 N/m of 1.4 kN/m" of the contact.
[[nodiscard]] std::string feltWords(const DeviceScale& scale, const ScaleJudgment& judgment);

/// Returns a sentence with numbers: what of a scale is too much, and the remedy; empty: it holds.
[[nodiscard]] std::string refusalOf(const ScaleJudgment& judgment);

/// Returns why a device cannot drive the tip.
[[nodiscard]] std::string refusalOf(const CoupledDevice& device);

}  // namespace asperity
