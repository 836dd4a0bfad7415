#pragma once

#include "core/haptics/device/HapticDevice.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

class HidTransport;

/// Context in which devices are found and opened.
struct DeviceSite {
    /// The access to HID devices; outlives the device. @throw Error where there is none
    std::function<HidTransport&()> hid;
    std::filesystem::path data = {};  ///< the folder `data` that belongs to the program
    Vector3 start = Vector3::Zero();  ///< position of the device before it [m]
};

/// A device that is there.
struct ListedDevice {
    std::string name;
    std::string path;  ///< of a HID device; else empty, as are its ids
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::string obstacle;  ///< why it cannot be used; empty: it can

    [[nodiscard]] bool usable() const { return obstacle.empty(); }
};

/// One kind of device, and all in which it differs from others. The folder of each driver has one,
/// and deviceDrivers() lists them.
struct DeviceDriver {
    const char* key = "";             ///< in reports
    const char* label = "";           ///< for people
    std::vector<std::string> senses;  ///< axes of the lab frame (x y z rx ry rz) and buttons
    bool rendersForce = false;        ///< it has motors
    /// The devices of this kind that are there. @throw Error when the system cannot list them
    std::vector<ListedDevice> (*list)(const DeviceSite& site) = {};
    /// Opens such a device. @throw Error where there cannot be one; a device that is not plugged in
    /// is waited for
    std::unique_ptr<HapticDevice> (*open)(const DeviceSite& site) = {};
};

}  // namespace asperity
