#pragma once

#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidTransport.h"

namespace asperity {

/// The system's HID devices, over hidapi and the kernel's hidraw.
class HidapiTransport final : public HidTransport {
public:
    /// @throw Error when hidapi cannot be made ready
    HidapiTransport();

    std::vector<HidDeviceInfo> enumerate() override;
    std::unique_ptr<HidConnection> open(const std::string& path) override;

private:
    class Library;
    class Connection;

    std::shared_ptr<Library> library_;  ///< shared with the connections
};

/// Function that returns whether a HID device is of some kind.
using HidKind = bool (*)(const HidDeviceInfo& device);

/// The HID devices of a kind, also those that this user may not open: a driver's list.
/// @throw Error when the system cannot list them
[[nodiscard]] std::vector<ListedDevice> listHid(const DeviceSite& site, HidKind isOfKind);

}  // namespace asperity
