#pragma once

#include "core/haptics/device/HapticDevice.h"
#include "core/realtime/TripleBuffer.h"

namespace asperity {

/// A device that mouse and keyboard pilot. They come some sixty times a second and in steps; it
/// follows smoothly, critically damped, so that nothing ever jumps.
class PilotedDevice : public HapticDevice {
public:
    /// Where the device shall go [m]. One thread, not the loop's; wait-free.
    void moveTo(const Vector3& target) noexcept { target_.write(target); }

    /// Where it is at first [m].
    [[nodiscard]] const Vector3& start() const noexcept { return start_; }

    [[nodiscard]] PilotedDevice* piloted() noexcept final { return this; }

protected:
    explicit PilotedDevice(const Vector3& start);

    /// Where it is after one more time step [s]. Loop thread only.
    const Vector3& pilot(double timeStep) noexcept;

private:
    Vector3 start_;  ///< [m]
    TripleBuffer<Vector3> target_;
    Vector3 position_;                    ///< [m]
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
};

}  // namespace asperity
