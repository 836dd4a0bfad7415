#pragma once

#include "core/Vector.h"
#include "core/realtime/TripleBuffer.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

#include <string>

namespace asperity {

class PilotedDevice;

/// Reason why a device cannot have the tip.
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

/// The maker's specification of a haptic device; a value of 0: not known, or it has none.
struct DeviceSpecification {
    double maxForce = 0.0;         ///< that its motors render [N]; 0: it only senses
    double maxStiffness = 0.0;     ///< that it renders [N/m]
    double maxDamping = 0.0;       ///< that it renders [N s/m]
    double effectiveMass = 0.0;    ///< of the handle [kg]
    double workspaceRadius = 0.0;  ///< of the ball about its zero in which the handle moves [m]
    bool streams = false;          ///< it reports all the time: that it falls silent is a fault
    bool calibrates = false;       ///< HapticDevice::calibrate() says where it is

    [[nodiscard]] bool rendersForce() const noexcept { return maxForce > 0.0; }
};

/// The device as the loop sees it: a haptic device, a mouse, a script. Blocking input and output
/// belong on a thread of the device's own; what is here never waits and never throws.
class HapticDevice {
public:
    virtual ~HapticDevice() = default;

    /// Constant while the device lives. Only a device that renders forces by this gets any, within
    /// these limits.
    [[nodiscard]] virtual DeviceSpecification specification() const noexcept = 0;

    /// Returns the device's state after one more time step [s]; the loop adds what the
    /// specification says. Loop thread only.
    virtual DeviceState advance(double timeStep) noexcept = 0;

    /// The device force [N]. Loop thread only. A force-feedback device switches its motors off by
    /// itself when it gets no force for a while, as from a program that crashed.
    virtual void setForce(const Vector3& /*force*/) noexcept {}

    /// Receives the last tick's output, for devices that the measured force moves. Loop thread
    /// only.
    virtual void observe(const TickOutput& /*output*/) noexcept {}

    /// The handle is in the device's rest pose now: for devices whose encoders count from there.
    /// Any thread; wait-free.
    virtual void calibrate() noexcept {}

    /// Time from a motion of the device to the force that answers it, as measured so far, without
    /// the hold of half a tick [s]. Any thread but the loop's.
    [[nodiscard]] virtual double delay() const noexcept { return 0.0; }

    /// Returns what the window shows of the device; nothing for mouse, keyboard and scripts. Any
    /// thread but the loop's.
    [[nodiscard]] virtual DeviceStatus status() const { return {}; }

    /// Half the width of what the operator sees [m]: for devices that are pushed, not moved, so
    /// that the tip is as fast on the screen whatever is seen. Any thread; wait-free.
    virtual void setSeenHalfWidth(double /*halfWidth*/) noexcept {}

    /// The device as one that mouse and keyboard pilot; null: it moves by itself.
    [[nodiscard]] virtual PilotedDevice* piloted() noexcept { return nullptr; }
};

/// A device that only senses.
inline constexpr DeviceSpecification kSensesOnly{};

/// A device that mouse and keyboard pilot. They come some sixty times a second and in steps; it
/// follows smoothly, critically damped, so that nothing ever jumps.
class PilotedDevice : public HapticDevice {
public:
    /// Sets where the device shall go [m]. One thread, not the loop's; wait-free.
    void moveTo(const Vector3& target) noexcept { target_.write(target); }

    /// Initial position [m].
    [[nodiscard]] const Vector3& start() const noexcept { return start_; }

    [[nodiscard]] PilotedDevice* piloted() noexcept final { return this; }

protected:
    explicit PilotedDevice(const Vector3& start);

    /// Returns the position after one more time step [s]. Loop thread only.
    const Vector3& pilot(double timeStep) noexcept;

private:
    Vector3 start_;  ///< [m]
    TripleBuffer<Vector3> target_;
    Vector3 position_;                    ///< [m]
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
};

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
