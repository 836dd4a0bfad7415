#pragma once

#include "core/haptics/device/LedHand.h"

namespace asperity {

/// Mouse and keyboard as the hand itself.
class PointerHand final : public LedHand {
public:
    /// @param start where the hand rests at first [m]
    explicit PointerHand(const Vector3& start) : LedHand(start) {}

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    HandState advance(double timeStep) noexcept override { return {.position = lead(timeStep)}; }
};

}  // namespace asperity
