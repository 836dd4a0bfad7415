#pragma once

#include "core/haptics/device/HapticDevice.h"
#include "core/io/scene/DeviceFiles.h"
#include "core/realtime/TripleBuffer.h"
#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidFollower.h"
#include "hardware/hid/HidTransport.h"
#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include <algorithm>
#include <atomic>
#include <optional>

namespace asperity {

/// The largest of the samples of the last one to two seconds, in two halves of a second each.
class RecentMaximum {
public:
    /// @param now when it was taken, not before the last one [s]
    void add(double sample, double now) noexcept {
        if (now - begin_ >= kHalf) {
            older_ = now - begin_ < 2.0 * kHalf ? newer_ : 0.0;
            newer_ = 0.0;
            begin_ = now;
        }
        newer_ = std::max(newer_, sample);
    }

    /// Returns the value of the last sample; 0 before the first. Samples are positive.
    [[nodiscard]] double value() const noexcept { return std::max(older_, newer_); }

private:
    static constexpr double kHalf = 1.0;  // [s]

    double begin_ = 0.0;  ///< of the newer half [s]
    double older_ = 0.0;
    double newer_ = 0.0;
};

/// A WoodenHaptics or Polhem: three joints with motors, over USB HID. A thread of its
/// own exchanges reports with the device, and without one looks for it twice a second. Positions
/// and forces are in the lab's frame, from the workspace's origin.
///
/// The motors get a force only while it answers a reading that is no older than 40 ms: a loop that
/// hangs, a device that falls silent and one that comes back feel none. Its encoders count from
/// the position at power-up: until calibrate() was called it is not connected, for positions and
/// the directions of forces would be wrong, and so it is again after it was lost. When the
/// program is killed, the firmware cuts the currents after half a second without a message.
class WoodenHaptics final : public HapticDevice {
public:
    /// Takes the first one that can be opened, and waits up to 0.2 s for its first answer.
    /// @param transport must outlive the device
    WoodenHaptics(HidTransport& transport, WoodenHapticsDescription description);
    /// Sends zero currents and joins the thread, in some hundredths of a second unless a write
    /// hangs.
    ~WoodenHaptics() override;
    WoodenHaptics(const WoodenHaptics&) = delete;
    WoodenHaptics& operator=(const WoodenHaptics&) = delete;

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return description_.specification;
    }
    DeviceState advance(double timeStep) noexcept override;
    void setForce(const Vector3& force) noexcept override;
    /// The longest of about the last two seconds, from the reading that a force answers until the
    /// device has taken the force.
    [[nodiscard]] double delay() const noexcept override {
        return delay_.load(std::memory_order_relaxed);
    }

    void calibrate() noexcept override {
        calibrationWanted_.store(true, std::memory_order_relaxed);
    }

    [[nodiscard]] DeviceStatus status() const override;

private:
    struct Reading {
        Vector3 position = Vector3::Zero();  ///< lab frame [m]
        bool button = false;
        bool connected = false;  ///< and calibrated
        double time = 0.0;       ///< when it was read; before the first: the beginning [s]
    };
    struct Order {
        Vector3 force = Vector3::Zero();  ///< lab frame [N]
        double answers = 0.0;             ///< time of the reading that it answers; 0: none [s]
    };
    /// A connection while it is followed.
    struct Link {
        HidConnection& device;
        WoodenHapticsBoard board;
        std::optional<Vector3> angles;  ///< of the joints, newest [rad]
        /// Readings until the encoders count from the rest pose; none: nobody calibrated them.
        std::optional<int> uncounted;

        [[nodiscard]] bool calibrated() const noexcept { return uncounted == 0; }
    };

    void awaitFirstReading() const;
    void follow(const FoundDevice& found, const std::stop_token& stop);
    bool listen(Link& link);
    bool answer(Link& link);
    [[nodiscard]] static bool isLive(const Link& link, const Order& order);
    void noteDelay(const Order& order);
    [[nodiscard]] WoodenHapticsMessage nextMessage(Link& link, const Vector3& force);

    const WoodenHapticsDescription description_;
    Reading latest_;  ///< the follower's thread's own
    TripleBuffer<Reading> reading_;
    TripleBuffer<Order> order_;
    std::atomic<bool> calibrationWanted_{false};
    std::atomic<bool> awaitsCalibration_{false};  ///< it answers, and nobody calibrated it
    std::atomic<double> delay_{0.0};
    double taken_ = 0.0;  ///< time of the reading that advance() took, 0: none [s]; the loop's own

    // The follower's thread's own.
    RecentMaximum delays_;
    double answered_ = 0.0;  ///< time of the reading whose answer was last timed [s]

    HidFollower follower_;  ///< last: its thread uses all the others
};

/// Returns whether this is the board of a WoodenHaptics: by its ids, which are those of any Teensy
/// that speaks raw HID and of any mbed. A Teensy has a second node, a serial port in HID reports:
/// that is none.
[[nodiscard]] bool isWoodenHaptics(const HidDeviceInfo& device);

/// Returns the driver of WoodenHaptics and Polhem.
[[nodiscard]] const DeviceDriver& woodenHapticsDriver();

}  // namespace asperity
