#pragma once

#include "hardware/driver/DeviceDriver.h"

#include <span>
#include <vector>

namespace asperity {

/// All drivers, in the order of the window's list; a HID device belongs to the first one that
/// lists it.
[[nodiscard]] std::span<const DeviceDriver* const> deviceDrivers();

/// A device and what Asperity can do with it.
struct DeviceDescription : ListedDevice {
    const DeviceDriver* driver = nullptr;  ///< null: none knows the device
};

/// What each driver lists, driver by driver; then the HID devices that no driver knows.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<DeviceDescription> listDevices(const DeviceSite& site);

}  // namespace asperity
