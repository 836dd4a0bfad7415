#include "app/session/ActiveDevice.h"

#include "app/program/DataFolder.h"
#include "core/haptics/ScriptedDevice.h"
#include "core/haptics/device/PilotedDevice.h"
#include "hardware/piloted/PilotedDrivers.h"

#include <memory>
#include <utility>

namespace asperity {

namespace {

constexpr double kJourney = 1.5;  // [s]

}  // namespace

void ActiveDevice::attach(LiveRun& run) {
    run_ = &run;
    use(pointerDriver());
}

void ActiveDevice::use(const DeviceDriver& driver) {
    take(&driver, [this, &driver] {
        return driver.open({.hid = [this]() -> HidTransport& { return hid(); },
                            .data = dataFolder(),
                            .start = run_->devicePosition()});
    });
}

void ActiveDevice::take(const DeviceDriver* driver, const LiveRun::MakeDevice& make) {
    run_->takeDevice(make);
    device_ = &run_->device();
    driver_ = driver;
    if (const PilotedDevice* const piloted = run_->device().piloted()) {
        pilot_ = DevicePilot(piloted->start());
    }
}

DevicePath ActiveDevice::leadIn(const Vector3& start) {
    DevicePath path = journey(run_->scene(), run_->basePosition(), start.head<2>(), kJourney);
    path.push_back({path.back().time + 0.1 * kJourney, start});
    return path;
}

void ActiveDevice::follow(const DevicePath& path) {
    take(nullptr, [this, &path] {
        DevicePath way = leadIn(path.front().position);
        const double begin = way.back().time - path.front().time;
        for (std::size_t i = 1; i < path.size(); ++i) {
            way.push_back({begin + path[i].time, path[i].position});
        }
        return std::make_unique<ScriptedDevice>(std::move(way), run_->settings().positionGain,
                                                run_->devicePosition());
    });
}

HidTransport& ActiveDevice::hid() {
    if (!transport_) {
        transport_.emplace();
    }
    return *transport_;
}

PilotedDevice* ActiveDevice::piloted() const {
    return isOurs() && run_->loop().running() ? run_->device().piloted() : nullptr;
}

bool ActiveDevice::isHardware() const {
    return run_ != nullptr && run_->device().piloted() == nullptr && !followsPath();
}

double ActiveDevice::reach() const {
    return driver() == &pointerDriver() ? 1.0 : 1.0 / run_->settings().positionGain;
}

void ActiveDevice::displace(const Vector3& displacement) {
    if (piloted() != nullptr) {
        pilot_.displace(reach() * displacement);
    }
}

void ActiveDevice::setVelocity(const Vector3& velocity) {
    if (run_ != nullptr) {
        pilot_.setVelocity(reach() * velocity);
    }
}

void ActiveDevice::travelTo(const Vector2& place) {
    if (piloted() != nullptr) {
        pilot_.follow(journey(run_->scene(), run_->basePosition(), place, kJourney));
    }
}

void ActiveDevice::advance(double seconds, double halfWidth) {
    if (PilotedDevice* const device = piloted()) {
        const DeviceMapping now{.device = run_->devicePosition(),
                                .base = run_->basePosition(),
                                .positionGain = run_->settings().positionGain};
        device->moveTo(pilot_.advance(seconds, now));
    }
    if (run_ != nullptr) {
        run_->device().setSeenHalfWidth(halfWidth);
    }
}

}  // namespace asperity
