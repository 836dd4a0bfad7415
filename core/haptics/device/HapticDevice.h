#pragma once

#include "core/Vector.h"
#include "core/haptics/device/DeviceSpecification.h"
#include "core/haptics/device/DeviceStatus.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

namespace asperity {

class PilotedDevice;

/// The device as the loop sees it: a haptic device, a mouse, a script. Blocking input and output
/// belong on a thread of the device's own; what is here never waits and never throws.
class HapticDevice {
public:
    virtual ~HapticDevice() = default;

    /// Constant while the device lives. Only a device that renders forces by this gets any, within
    /// these limits.
    [[nodiscard]] virtual DeviceSpecification specification() const noexcept = 0;

    /// Where the device is after one more time step [s]; the loop adds what the specification says.
    /// Loop thread only.
    virtual DeviceState advance(double timeStep) noexcept = 0;

    /// The device force [N]. Loop thread only. A force-feedback device switches its motors off by
    /// itself when it gets no force for a while, as from a program that crashed.
    virtual void setForce(const Vector3& /*force*/) noexcept {}

    /// What the last tick computed: for devices that move by the measured force. Loop thread only.
    virtual void observe(const TickOutput& /*output*/) noexcept {}

    /// The handle is in the device's rest pose now: for devices whose encoders count from there.
    /// Any thread; wait-free.
    virtual void calibrate() noexcept {}

    /// How long it takes from a motion of the device to the force that answers it, as measured so
    /// far, without the hold of half a tick [s]. Any thread but the loop's.
    [[nodiscard]] virtual double delay() const noexcept { return 0.0; }

    /// What the window shows of the device; nothing of mouse, keyboard and scripts. Any thread but
    /// the loop's.
    [[nodiscard]] virtual DeviceStatus status() const { return {}; }

    /// Half the width of what the operator sees [m]: for devices that are pushed, not moved, so
    /// that the tip is as fast on the screen whatever is seen. Any thread; wait-free.
    virtual void setSeenHalfWidth(double /*halfWidth*/) noexcept {}

    /// The device as one that mouse and keyboard pilot; null: it moves by itself.
    [[nodiscard]] virtual PilotedDevice* piloted() noexcept { return nullptr; }
};

/// A device that only senses.
inline constexpr DeviceSpecification kSensesOnly{};

}  // namespace asperity
