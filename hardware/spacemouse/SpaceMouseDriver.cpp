#include "hardware/spacemouse/SpaceMouseDriver.h"

#include "hardware/hid/HidList.h"
#include "hardware/spacemouse/SpaceMouse.h"

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

}  // namespace

bool isSpaceMouse(const HidDeviceInfo& device) {
    const bool known = std::ranges::any_of(kSpaceMice, [&device](const ProductRange& range) {
        return device.vendorId == range.vendorId && device.productId >= range.first &&
               device.productId <= range.last;
    });
    return known && device.hasCollection(kMultiAxisController);
}

const DeviceDriver& spaceMouseDriver() {
    static const DeviceDriver driver{
        .key = "SpaceMouse",
        .label = "SpaceMouse",
        .senses = {"x", "y", "z", "rx", "ry", "rz", "buttons"},
        .list = [](const DeviceSite& site) { return listHid(site, isSpaceMouse); },
        .open = [](const DeviceSite& site) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<SpaceMouse>(site.hid(), site.start);
        }};
    return driver;
}

}  // namespace asperity
