#pragma once

#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidTransport.h"

namespace asperity {

/// Whether a HID device is of some kind.
using HidKind = bool (*)(const HidDeviceInfo& device);

/// The HID devices of a kind, also those that this user may not open: a driver's list.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<ListedDevice> listHid(const DeviceSite& site, HidKind isOfKind);

}  // namespace asperity
