#include "hardware/woodenhaptics/WoodenHapticsDriver.h"

#include "hardware/woodenhaptics/WoodenHapticsReports.h"

namespace asperity {

namespace {

constexpr HidUsage kTeensySerialPort = {.page = 0xFFC9, .id = 0x04};

}  // namespace

bool isWoodenHaptics(const HidDeviceInfo& device) {
    return woodenHapticsBoard(device.vendorId, device.productId) &&
           !device.hasCollection(kTeensySerialPort);
}

const DeviceDriver& woodenHapticsDriver() {
    static const DeviceDriver driver{.name = "WoodenHaptics",
                                     .senses = {"x", "y", "z", "buttons"},
                                     .rendersForce = true,
                                     .drives = isWoodenHaptics};
    return driver;
}

}  // namespace asperity
