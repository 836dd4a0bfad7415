#pragma once

#include "core/haptics/device/HapticDevice.h"
#include "hardware/hid/HidTransport.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// Where a device is opened.
struct DeviceSite {
    /// The way to HID devices; outlives the device. @throw Error where there is none
    std::function<HidTransport&()> hid;
    std::filesystem::path data;       ///< the folder `data` that belongs to the program
    Vector3 start = Vector3::Zero();  ///< where the device before it is [m]
};

/// One kind of device, and all in which it differs from others. The folder of each driver has one,
/// and deviceDrivers() lists them.
struct DeviceDriver {
    const char* key = "";             ///< in reports
    const char* label = "";           ///< for people
    std::vector<std::string> senses;  ///< axes of the lab frame and buttons
    bool rendersForce = false;        ///< it has motors
    /// Whether a HID device is of this kind.
    bool (*drives)(const HidDeviceInfo& device) = [](const HidDeviceInfo&) { return false; };
    /// Opens such a device. @throw Error where there cannot be one; one whose device is not
    /// there waits for it
    std::unique_ptr<HapticDevice> (*open)(const DeviceSite& site) = {};
};

}  // namespace asperity
