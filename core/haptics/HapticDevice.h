#pragma once

#include "core/Vector.h"
#include "core/scene/TickInput.h"

namespace asperity {

/// The hand as the loop sees it: a haptic device, a mouse, a script. Blocking input and output
/// belong on a thread of the device's own; what is here never waits and never throws.
class HapticDevice {
public:
    virtual ~HapticDevice() = default;

    /// Where the hand is after one more time step [s]. Loop thread only.
    virtual HandState advance(double timeStep) noexcept = 0;

    /// The force that the hand shall feel, lab frame [N]. Loop thread only. Devices that only
    /// sense have nothing to do with it. A device with motors says so in HandState::maxForce, else
    /// no governor guards its hand; and it lets go by itself when it is not told a force for a
    /// while, for a program that crashed tells it none.
    virtual void setForce(const Vector3& force) noexcept;
};

}  // namespace asperity
