#pragma once

#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidTransport.h"

namespace asperity {

/// Whether this is the board of a WoodenHaptics: by its ids, which are those of any Teensy that
/// speaks raw HID and of any mbed. A Teensy has a second node, a serial port in HID reports: that
/// is none.
[[nodiscard]] bool isWoodenHaptics(const HidDeviceInfo& device);

/// For WoodenHaptics and Polhem.
[[nodiscard]] const DeviceDriver& woodenHapticsDriver();

}  // namespace asperity
