#include "hardware/DeviceRegistry.h"

#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/device/HapticDevice.h"
#include "hardware/hid/HidapiTransport.h"
#include "hardware/spacemouse/SpaceMouse.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"

#include <algorithm>
#include <array>
#include <utility>

namespace asperity {

std::span<const DeviceDriver* const> deviceDrivers() {
    static const std::array drivers{&pointerDriver(), &spaceMouseDriver(), &simulatedDriver(),
                                    &woodenHapticsDriver()};
    return drivers;
}

std::vector<DeviceDescription> listDevices(const DeviceSite& site) {
    std::vector<DeviceDescription> all;
    const auto add = [&all](ListedDevice device, const DeviceDriver* driver) {
        if (device.path.empty() ||
            std::ranges::count(all, device.path, &DeviceDescription::path) == 0) {
            all.push_back({std::move(device), driver});
        }
    };
    for (const DeviceDriver* const driver : deviceDrivers()) {
        for (ListedDevice& device : driver->list(site)) {
            add(std::move(device), driver);
        }
    }
    for (ListedDevice& device : listHid(site, [](const HidDeviceInfo&) { return true; })) {
        device.obstacle = "no driver for this device";
        add(std::move(device), nullptr);
    }
    return all;
}

const DeviceDriver& pointerDriver() {
    static const DeviceDriver driver{
        .key = "window",
        .label = "Mouse and keyboard",
        .senses = {"x", "y", "z", "buttons"},
        .list = [](const DeviceSite&) -> std::vector<ListedDevice> {
            return {{.name = "mouse and keyboard"}};
        },
        .open = [](const DeviceSite& site) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<PointerDevice>(site.start);
        }};
    return driver;
}

const DeviceDriver& simulatedDriver() {
    static const DeviceDriver driver{
        .key = "simulated",
        .label = "Simulated device",
        .senses = {"x", "y", "z"},
        .rendersForce = true,
        .list = [](const DeviceSite&) -> std::vector<ListedDevice> {
            return {{.name = "simulated device"}};
        },
        .open = [](const DeviceSite&) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<SimulatedDevice>(Vector3::Zero());
        }};
    return driver;
}

}  // namespace asperity
