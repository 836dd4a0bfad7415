#pragma once

#include "core/haptics/device/HapticDevice.h"
#include "core/realtime/TripleBuffer.h"
#include "hardware/hid/HidFollower.h"
#include "hardware/spacemouse/SpaceMouseReports.h"

#include <atomic>

namespace asperity {

/// A SpaceMouse: its knob's deflection is the velocity of the device position. It senses only and
/// renders no force. A thread of its own reads the knob, and while it is unplugged looks for it
/// twice a second; meanwhile the position rests and is not connected.
class SpaceMouse final : public HapticDevice {
public:
    static constexpr double kDefaultSpeed = 20e-9;  ///< [m/s]

    /// Takes the first SpaceMouse that can be opened; one that is there is connected at once.
    /// @param transport must outlive the device
    /// @param start     where the device is at first [m]
    /// @param fullSpeed of the device when the knob is pushed to its end [m/s]
    SpaceMouse(HidTransport& transport, Vector3 start, double fullSpeed = kDefaultSpeed);
    /// Puts the light out and joins the thread, in some hundredths of a second.
    ~SpaceMouse() override;
    SpaceMouse(const SpaceMouse&) = delete;
    SpaceMouse& operator=(const SpaceMouse&) = delete;

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;

    /// The device's speed at full deflection [m/s]. Any thread; wait-free.
    void setSpeed(double fullSpeed) noexcept {
        fullSpeed_.store(fullSpeed, std::memory_order_relaxed);
    }

    /// At full deflection it crosses half the view in 2 s.
    void setSeenHalfWidth(double halfWidth) noexcept override { setSpeed(0.5 * halfWidth); }

    [[nodiscard]] DeviceStatus status() const override { return follower_.status(); }

private:
    struct Reading {
        SpaceMouseState state;
        bool connected = false;
    };

    void follow(HidConnection& device, const std::stop_token& stop);

    Vector3 position_;  ///< of the device; the loop thread's own [m]
    std::atomic<double> fullSpeed_;
    TripleBuffer<Reading> reading_;
    HidFollower follower_;  ///< last: its thread uses all the others
};

}  // namespace asperity
