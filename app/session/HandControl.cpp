#include "app/session/HandControl.h"

#include "app/program/DataFolder.h"
#include "core/haptics/ScriptedHand.h"
#include "core/haptics/device/LedHand.h"
#include "hardware/led/LedDrivers.h"

#include <memory>
#include <utility>

namespace asperity {

namespace {

constexpr double kJourney = 1.5;  // [s]

}  // namespace

void HandControl::attach(LiveRun& run) {
    run_ = &run;
    use(pointerDriver());
}

void HandControl::use(const DeviceDriver& driver) {
    take(&driver, [this, &driver] {
        return driver.open({.hid = [this]() -> HidTransport& { return hid(); },
                            .data = dataFolder(),
                            .start = run_->handPosition()});
    });
}

void HandControl::take(const DeviceDriver* driver, const LiveRun::MakeHand& make) {
    run_->takeHand(make);
    hand_ = &run_->hand();
    driver_ = driver;
    if (const LedHand* const led = run_->hand().led()) {
        pilot_ = HandPilot(led->start());
    }
}

HandPath HandControl::leadIn(const Vector3& start) {
    HandPath path = journey(run_->scene(), run_->basePosition(), start.head<2>(), kJourney);
    path.push_back({path.back().time + 0.1 * kJourney, start});
    return path;
}

void HandControl::follow(const HandPath& path) {
    take(nullptr, [this, &path] {
        HandPath way = leadIn(path.front().position);
        const double begin = way.back().time - path.front().time;
        for (std::size_t i = 1; i < path.size(); ++i) {
            way.push_back({begin + path[i].time, path[i].position});
        }
        return std::make_unique<ScriptedHand>(std::move(way), run_->settings().positionGain,
                                              run_->handPosition());
    });
}

HidTransport& HandControl::hid() {
    if (!transport_) {
        transport_.emplace();
    }
    return *transport_;
}

LedHand* HandControl::led() const {
    return isOurs() && run_->loop().running() ? run_->hand().led() : nullptr;
}

bool HandControl::isDevice() const {
    return run_ != nullptr && run_->hand().led() == nullptr && !followsPath();
}

double HandControl::reach() const {
    return driver() == &pointerDriver() ? 1.0 : 1.0 / run_->settings().positionGain;
}

void HandControl::displace(const Vector3& displacement) {
    if (led() != nullptr) {
        pilot_.displace(reach() * displacement);
    }
}

void HandControl::setVelocity(const Vector3& velocity) {
    if (run_ != nullptr) {
        pilot_.setVelocity(reach() * velocity);
    }
}

void HandControl::travelTo(const Vector2& place) {
    if (led() != nullptr) {
        pilot_.follow(journey(run_->scene(), run_->basePosition(), place, kJourney));
    }
}

void HandControl::advance(double seconds, double halfWidth) {
    if (LedHand* const hand = led()) {
        const HandMapping now{.hand = run_->handPosition(),
                              .base = run_->basePosition(),
                              .positionGain = run_->settings().positionGain};
        hand->moveTo(pilot_.advance(seconds, now));
    }
    if (run_ != nullptr) {
        run_->hand().setSeenHalfWidth(halfWidth);
    }
}

}  // namespace asperity
