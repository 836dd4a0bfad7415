#pragma once

#include <string>

namespace asperity {

/// Why a device cannot have the tip.
enum class DeviceProblem {
    None,
    NotPluggedIn,
    NotPermitted,  ///< this user may not open it
    NotOpened,     ///< the system says why
    Unplugged,     ///< it was there before
};

/// State of a device, beside its position. Text is UTF-8.
struct DeviceStatus {
    DeviceProblem problem = DeviceProblem::None;
    std::string driver;      ///< what drives it, for people
    std::string name;        ///< of the device; empty: there is none
    std::string path;        ///< where the system has it
    std::string reason;      ///< that the system gave, of one that could not be opened
    bool calibrated = true;  ///< false: it waits for HapticDevice::calibrate()

    [[nodiscard]] bool connected() const noexcept {
        return problem == DeviceProblem::None && !name.empty();
    }
};

}  // namespace asperity
