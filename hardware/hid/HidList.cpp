#include "hardware/hid/HidList.h"

#include "core/words/DeviceWords.h"

namespace asperity {

std::vector<ListedDevice> listHid(const DeviceSite& site, HidKind isOfKind) {
    std::vector<ListedDevice> list;
    for (const HidDeviceInfo& device : site.hid().enumerate()) {
        if (isOfKind(device)) {
            list.push_back({.name = device.name(),
                            .path = device.path,
                            .vendorId = device.vendorId,
                            .productId = device.productId,
                            .obstacle = device.permitted ? "" : kNoPermission});
        }
    }
    return list;
}

}  // namespace asperity
