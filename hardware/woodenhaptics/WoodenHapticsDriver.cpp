#include "hardware/woodenhaptics/WoodenHapticsDriver.h"

#include "core/io/scene/WoodenHapticsFile.h"
#include "hardware/hid/HidList.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"
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
    static const DeviceDriver driver{
        .key = "WoodenHaptics",
        .label = "WoodenHaptics",
        .senses = {"x", "y", "z", "buttons"},
        .rendersForce = true,
        .list = [](const DeviceSite& site) { return listHid(site, isWoodenHaptics); },
        .open = [](const DeviceSite& site) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<WoodenHaptics>(
                site.hid(), readWoodenHaptics(site.data / "devices" / "woodenhaptics_2015.toml"));
        }};
    return driver;
}

}  // namespace asperity
