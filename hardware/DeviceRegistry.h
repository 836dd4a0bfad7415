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

/// Lists the devices of each driver, driver by driver; then the HID devices that no driver knows.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<DeviceDescription> listDevices(const DeviceSite& site);

/// Returns the driver of mouse and keyboard themselves.
[[nodiscard]] const DeviceDriver& pointerDriver();

/// Returns the driver of the simulated haptic device, which mouse and keyboard pilot.
[[nodiscard]] const DeviceDriver& simulatedDriver();

}  // namespace asperity
