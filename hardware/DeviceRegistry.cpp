#include "hardware/DeviceRegistry.h"

#include "hardware/hid/HidList.h"
#include "hardware/piloted/PilotedDrivers.h"
#include "hardware/spacemouse/SpaceMouseDriver.h"
#include "hardware/woodenhaptics/WoodenHapticsDriver.h"

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

}  // namespace asperity
