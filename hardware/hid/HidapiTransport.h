#pragma once

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

}  // namespace asperity
