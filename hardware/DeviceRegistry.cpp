#include "hardware/DeviceRegistry.h"

#include "hardware/woodenhaptics/WoodenHapticsReports.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

struct ProductRange {
    std::uint16_t vendorId;
    std::uint16_t first;
    std::uint16_t last;
};

// Logitech made them first. CadMice lie at 256f:c650-c658, among them the receiver for all, c652.
constexpr std::array kSpaceMice = {ProductRange{0x046d, 0xc603, 0xc640},
                                   ProductRange{0x256f, 0xc62e, 0xc64f},
                                   ProductRange{0x256f, 0xc652, 0xc652}};

constexpr HidUsage kMultiAxisController = {.page = 0x01, .id = 0x08};
constexpr HidUsage kTeensySerialPort = {.page = 0xFFC9, .id = 0x04};

bool hasCollection(const HidDeviceInfo& device, const HidUsage& usage) {
    return std::find(device.usages.begin(), device.usages.end(), usage) != device.usages.end();
}

std::string nameOf(const HidDeviceInfo& device) {
    if (!device.product.empty()) {
        return device.product;
    }
    return device.manufacturer.empty() ? "HID device" : device.manufacturer + " HID device";
}

DeviceDescription describe(const HidDeviceInfo& device) {
    DeviceDescription description = {.name = nameOf(device),
                                     .path = device.path,
                                     .vendorId = device.vendorId,
                                     .productId = device.productId};
    if (isSpaceMouse(device)) {
        description.driver = kSpaceMouseDriver;
        description.senses = {"x", "y", "z", "rx", "ry", "rz", "buttons"};
    } else if (isWoodenHaptics(device)) {
        description.driver = kWoodenHapticsDriver;
        description.senses = {"x", "y", "z", "buttons"};
        description.rendersForce = true;
    }
    if (description.driver.empty()) {
        description.obstacle = "no driver for this device";
    } else if (!device.permitted) {
        description.obstacle = kNoPermission;
    }
    return description;
}

}  // namespace

bool isSpaceMouse(const HidDeviceInfo& device) {
    const bool known =
        std::any_of(kSpaceMice.begin(), kSpaceMice.end(), [&device](const ProductRange& range) {
            return device.vendorId == range.vendorId && device.productId >= range.first &&
                   device.productId <= range.last;
        });
    return known && hasCollection(device, kMultiAxisController);
}

bool isWoodenHaptics(const HidDeviceInfo& device) {
    return woodenHapticsBoard(device.vendorId, device.productId) &&
           !hasCollection(device, kTeensySerialPort);
}

std::vector<DeviceDescription> listDevices(HidTransport& transport) {
    std::vector<DeviceDescription> list;
    for (const HidDeviceInfo& device : transport.enumerate()) {
        list.push_back(describe(device));
    }
    return list;
}

}  // namespace asperity
