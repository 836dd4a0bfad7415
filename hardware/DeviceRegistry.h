#pragma once

#include "hardware/hid/DeviceDriver.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// All drivers, in the order of the window's list; a HID device belongs to the first one that
/// drives it.
[[nodiscard]] std::span<const DeviceDriver* const> deviceDrivers();

/// A device and what Asperity can do with it.
struct DeviceDescription {
    std::string name;
    std::string driver;  ///< of Asperity; empty: none knows the device
    std::string path;
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::vector<std::string> senses;  ///< axes of the lab frame (x y z rx ry rz) and buttons
    bool rendersForce = false;
    std::string obstacle;  ///< why it cannot be used; empty: it can

    [[nodiscard]] bool usable() const { return obstacle.empty(); }
};

/// Every HID device with what can be done with it, also those that no driver knows.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<DeviceDescription> listDevices(HidTransport& transport);

}  // namespace asperity
