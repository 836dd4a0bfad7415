#pragma once

#include "hardware/woodenhaptics/WoodenHapticsModel.h"
#include "tests/hardware/VirtualHid.h"

#include <thread>

namespace asperity::test {

/// Events of the motors of the device.
enum class MotorEvent : std::uint8_t {
    Zero,   ///< a message with zero currents
    Drive,  ///< a message with currents
    Cut,    ///< half a second without a message: the firmware cut the amplifiers by itself
};

/// A WoodenHaptics with a Teensy over umockdev, and its firmware: it answers each message with a
/// reading, and cuts the motors after 0.5 s without one. Source: docs/device_protocols.md 2.
class VirtualWoodenHaptics {
public:
    /// Plugged in, its handle here. @param handle lab frame, from the workspace's origin [m]
    explicit VirtualWoodenHaptics(const Vector3& handle);

    /// Moves the handle as slowly as a hand does.
    void moveTo(const Vector3& handle);
    void plug() { hid_.plug(); }
    void unplug() { hid_.unplug(); }
    [[nodiscard]] std::vector<MotorEvent> events() const;

private:
    void run(const std::stop_token& stop);
    void obey(const VirtualHid::Report& message);
    void hold(const Vector3& handle);
    [[nodiscard]] VirtualHid::Report reading() const;

    VirtualHid hid_;
    Vector3 handle_;  ///< the test's own [m]

    mutable std::mutex mutex_;
    EncoderCounts counts_{};
    std::vector<MotorEvent> events_;

    // The firmware's own.
    bool enabled_ = false;      ///< the amplifiers
    double lastMessage_ = 0.0;  ///< [s]
    std::jthread firmware_;     ///< last: it uses all the others
};

}  // namespace asperity::test
