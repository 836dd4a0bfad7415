#include "app/session/ActiveDevice.h"

#include "app/program/DataFolder.h"
#include "core/haptics/LiftStep.h"
#include "core/haptics/PlannedApproach.h"
#include "core/haptics/ScriptedDevice.h"
#include "core/haptics/device/PilotedDevice.h"
#include "hardware/piloted/PilotedDrivers.h"

#include <limits>
#include <memory>
#include <utility>

namespace asperity {

namespace {

constexpr double kJourney = 1.5;  // [s]

// To engage takes about two seconds: down to right above the sample, then slowly to the setpoint.
constexpr double kCoarse = 0.7;  // [s]
constexpr double kFine = 3.0;    // of an approach with its way back [s]

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
    approach_ = nullptr;
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

void ActiveDevice::approachBy(const MakeLeadIn& makeLeadIn, const ApproachPlan& plan) {
    const ApproachDevice* made = nullptr;
    take(nullptr, [&] {
        auto device = std::make_unique<ApproachDevice>(
            makeLeadIn(), plan, run_->settings().positionGain, run_->devicePosition());
        made = device.get();
        return device;
    });
    approach_ = made;
}

void ActiveDevice::approach(const PlannedApproach& approach) {
    approachBy([&] { return leadIn(approach.start); }, approach.plan);
}

void ActiveDevice::engage(double setpoint) {
    const Vector2 here = run_->basePosition().head<2>();
    PlannedApproach planned =
        planApproach(run_->scene(), {.duration = kFine, .place = here, .setpoint = setpoint});
    planned.plan.dwell = std::numeric_limits<double>::infinity();
    const auto straightDown = [&]() -> DevicePath {
        const Vector3 base = run_->basePosition();
        return {{0.0, base}, {kCoarse, {base.x(), base.y(), planned.start.z()}}};
    };
    approachBy(straightDown, planned.plan);
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

double ActiveDevice::pilotedHeight() const {
    const ContactState& contact = run_->loop().snapshot().sample.output.model.contact;
    const double height = contact.branch == ContactBranch::Far ? -contact.indentation : 0.0;
    const Vector3 ahead = pilot_.target() - run_->devicePosition();
    return height + run_->settings().positionGain * ahead.z();
}

void ActiveDevice::lift(double notches, double fineStep) {
    if (piloted() == nullptr || !(fineStep > 0.0)) {
        return;
    }
    const double gain = run_->settings().positionGain;
    const double height = pilotedHeight();
    const double lifted = liftedHeight(height, notches, gain * reach() * fineStep);
    pilot_.displace((lifted - height) / gain * Vector3::UnitZ());
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
