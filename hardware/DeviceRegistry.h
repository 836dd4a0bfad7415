#pragma once

#include "hardware/HidTransport.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// The driver for the SpaceMice of 3Dconnexion.
inline constexpr const char* kSpaceMouseDriver = "SpaceMouse";
/// The driver for WoodenHaptics and Polhem.
inline constexpr const char* kWoodenHapticsDriver = "WoodenHaptics";

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

/// Whether this is a SpaceMouse of 3Dconnexion: by its ids and by a collection for six axes. Their
/// CadMice have ids in between, and receivers have nodes that are keyboards; both are none.
[[nodiscard]] bool isSpaceMouse(const HidDeviceInfo& device);

/// Whether this is the board of a WoodenHaptics: by its ids, which are those of any Teensy that
/// speaks raw HID and of any mbed. A Teensy has a second node, a serial port in HID reports: that
/// is none.
[[nodiscard]] bool isWoodenHaptics(const HidDeviceInfo& device);

/// Every HID device with what can be done with it, also those that no driver knows.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<DeviceDescription> listDevices(HidTransport& transport);

}  // namespace asperity
