#include "hardware/piloted/PilotedDrivers.h"

#include "core/haptics/bench/SimulatedDevice.h"
#include "core/haptics/device/PointerDevice.h"

namespace asperity {

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
