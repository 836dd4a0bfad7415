#pragma once

#include "core/haptics/DevicePath.h"
#include "core/haptics/device/HapticDevice.h"

namespace asperity {

/// A device that follows a path, then rests at its end.
class ScriptedDevice final : public HapticDevice {
public:
    /// For a run that begins with it.
    /// @param path         of the base, world [m]
    /// @param positionGain base displacement per device displacement while the path runs
    ScriptedDevice(DevicePath path, double positionGain);
    /// For a device that takes over from another one.
    /// @param start where that one is, in the device's frame, while the base is where `path` begins
    ScriptedDevice(DevicePath path, double positionGain, Vector3 start);

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;

private:
    DevicePath path_;
    double positionGain_;
    Vector3 start_;         ///< of the device [m]
    double time_ = 0.0;     ///< along the path [s]
    bool started_ = false;  ///< the first step only begins
};

}  // namespace asperity
