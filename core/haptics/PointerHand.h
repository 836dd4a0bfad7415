#pragma once

#include "core/haptics/HapticDevice.h"
#include "core/realtime/TripleBuffer.h"

namespace asperity {

/// A hand led by mouse and keyboard. They come some sixty times a second and in steps; the hand
/// follows them smoothly, critically damped, so that the tip never jumps.
class PointerHand final : public HapticDevice {
public:
    /// @param start where the hand rests at first [m]
    explicit PointerHand(const Vector3& start);

    /// Where the hand shall go [m]. One thread, not the loop's; wait-free.
    void moveTo(const Vector3& target) noexcept { target_.write(target); }

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    HandState advance(double timeStep) noexcept override;

private:
    TripleBuffer<Vector3> target_;
    Vector3 position_;
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
};

}  // namespace asperity
