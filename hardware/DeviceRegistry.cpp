#include "hardware/DeviceRegistry.h"

#include "core/words/DeviceWords.h"
#include "hardware/led/LedDrivers.h"
#include "hardware/spacemouse/SpaceMouseDriver.h"
#include "hardware/woodenhaptics/WoodenHapticsDriver.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

DeviceDescription describe(const HidDeviceInfo& device) {
    DeviceDescription description = {.name = device.name(),
                                     .path = device.path,
                                     .vendorId = device.vendorId,
                                     .productId = device.productId};
    const auto drivers = deviceDrivers();
    const auto found = std::ranges::find_if(
        drivers, [&device](const DeviceDriver* driver) { return driver->drives(device); });
    if (found == drivers.end()) {
        description.obstacle = "no driver for this device";
        return description;
    }
    const DeviceDriver& driver = **found;
    description.driver = driver.key;
    description.senses = driver.senses;
    description.rendersForce = driver.rendersForce;
    if (!device.permitted) {
        description.obstacle = kNoPermission;
    }
    return description;
}

}  // namespace

std::span<const DeviceDriver* const> deviceDrivers() {
    static const std::array drivers{&pointerDriver(), &spaceMouseDriver(), &simulatedDriver(),
                                    &woodenHapticsDriver()};
    return drivers;
}

std::vector<DeviceDescription> listDevices(HidTransport& transport) {
    std::vector<DeviceDescription> list;
    for (const HidDeviceInfo& device : transport.enumerate()) {
        list.push_back(describe(device));
    }
    return list;
}

}  // namespace asperity
