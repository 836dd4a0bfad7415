#include "core/haptics/ScriptedDevice.h"

#include <utility>

namespace asperity {

ScriptedDevice::ScriptedDevice(DevicePath path, double positionGain)
    : path_(std::move(path))
    , positionGain_(positionGain)
    , start_(path_.front().position / positionGain) {}

ScriptedDevice::ScriptedDevice(DevicePath path, double positionGain, Vector3 start)
    : path_(std::move(path)), positionGain_(positionGain), start_(std::move(start)) {}

DeviceState ScriptedDevice::advance(double timeStep) noexcept {
    if (started_) {
        time_ += timeStep;
    }
    started_ = true;
    const Vector3 way = positionAt(path_, time_) - path_.front().position;
    return {.position = start_ + way / positionGain_};
}

}  // namespace asperity
