#pragma once

#include "core/haptics/device/PilotedDevice.h"

namespace asperity {

/// Mouse and keyboard as the device itself.
class PointerDevice final : public PilotedDevice {
public:
    /// @param start where the device rests at first [m]
    explicit PointerDevice(const Vector3& start) : PilotedDevice(start) {}

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override { return {.position = pilot(timeStep)}; }
};

}  // namespace asperity
