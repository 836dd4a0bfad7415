#pragma once

#include "hardware/hid/HidTransport.h"

#include <string>
#include <vector>

namespace asperity {

/// What Asperity can do with one kind of HID device. The folder of each driver has one, and
/// deviceDrivers() lists them.
struct DeviceDriver {
    const char* name = "";                             ///< for people and files
    std::vector<std::string> senses;                   ///< axes of the lab frame and buttons
    bool rendersForce = false;                         ///< it has motors
    bool (*drives)(const HidDeviceInfo& device) = {};  ///< whether this is such a device
};

}  // namespace asperity
