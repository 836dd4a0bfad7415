#pragma once

#include "core/Vector.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/realtime/TripleBuffer.h"
#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidFollower.h"
#include "hardware/hid/HidTransport.h"

#include <atomic>
#include <cstdint>
#include <span>

namespace asperity {

/// Displacement of a SpaceMouse's knob, and the buttons that are down. Lab frame: x right, y away
/// from the operator (up in the image), z up; rotations right-handed about these axes.
struct SpaceMouseState {
    Vector3 translation = Vector3::Zero();  ///< -1..1 an axis
    Vector3 rotation = Vector3::Zero();     ///< -1..1 an axis
    std::uint32_t buttons = 0;              ///< bit i: button i is down
};

/// Returns the state once the device has also sent `report` (its id first): translation and
/// rotation in one report or, older, in two; buttons in another. A report that is not known, or
/// that has not the length it must have, changes nothing. Source: docs/device_protocols.md 1:
/// little-endian, +-350, x right, y to the operator, z down.
[[nodiscard]] SpaceMouseState afterReport(const SpaceMouseState& before,
                                          std::span<const std::uint8_t> report) noexcept;

/// A SpaceMouse: its knob's deflection is the velocity of the device position. It senses only and
/// renders no force. A thread of its own reads the knob, and while it is unplugged looks for it
/// twice a second; until then the position rests and is not connected.
class SpaceMouse final : public HapticDevice {
public:
    static constexpr double kDefaultSpeed = 20e-9;  ///< [m/s]

    /// Takes the first SpaceMouse that can be opened; one that is there is connected at once.
    /// @param transport must outlive the device
    /// @param start     position of the device at first [m]
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

/// Returns whether this is a SpaceMouse of 3Dconnexion: by its ids and a collection for six axes.
/// Their CadMice have ids in between, and receivers have nodes that are keyboards; both are none.
[[nodiscard]] bool isSpaceMouse(const HidDeviceInfo& device);

/// Returns the driver of 3Dconnexion's SpaceMice.
[[nodiscard]] const DeviceDriver& spaceMouseDriver();

}  // namespace asperity
