#include "app/HandControl.h"

#include "core/haptics/PointerHand.h"
#include "core/haptics/ScriptedHand.h"
#include "hardware/SpaceMouse.h"

#include <memory>
#include <utility>

namespace asperity {

namespace {

constexpr double kJourney = 1.5;     // [s]
constexpr double kMouseSpeed = 0.5;  // of a SpaceMouse pushed to its end [half widths/s]

}  // namespace

void HandControl::attach(LiveRun& run) {
    run_ = &run;
    usePointer();
}

void HandControl::detach() {
    letGo();
    run_ = nullptr;
}

void HandControl::letGo() {
    pointer_ = nullptr;
    spaceMouse_ = nullptr;
    pilot_.reset();
}

void HandControl::usePointer() {
    run_->takeHand([this] {
        auto hand = std::make_unique<PointerHand>(run_->handPosition());
        letGo();
        pointer_ = hand.get();
        pilot_.emplace(run_->handPosition());
        return hand;
    });
}

HandPath HandControl::leadIn(const Vector3& start) {
    HandPath path = journey(run_->scene(), run_->basePosition(), start.head<2>(), kJourney);
    path.push_back({path.back().time + 0.1 * kJourney, start});
    return path;
}

void HandControl::follow(const HandPath& path) {
    run_->takeHand([this, &path] {
        HandPath way = leadIn(path.front().position);
        const double begin = way.back().time - path.front().time;
        for (std::size_t i = 1; i < path.size(); ++i) {
            way.push_back({begin + path[i].time, path[i].position});
        }
        letGo();
        return std::make_unique<ScriptedHand>(std::move(way), run_->settings().positionGain,
                                              run_->handPosition());
    });
}

void HandControl::useSpaceMouse() {
    if (!transport_) {
        transport_.emplace();
    }
    run_->takeHand([this] {
        auto hand = std::make_unique<SpaceMouse>(*transport_, run_->handPosition());
        letGo();
        spaceMouse_ = hand.get();
        return hand;
    });
}

bool HandControl::leads() const { return pilot_ && run_->loop().running(); }

void HandControl::displace(const Vector3& displacement) {
    if (leads()) {
        pilot_->displace(displacement);
    }
}

void HandControl::setVelocity(const Vector3& velocity) {
    if (pilot_) {
        pilot_->setVelocity(velocity);
    }
}

void HandControl::travelTo(const Vector2& place) {
    if (!leads()) {
        return;
    }
    pilot_->follow(journey(run_->scene(), run_->basePosition(), place, kJourney));
}

void HandControl::advance(double seconds, double halfWidth) {
    if (leads()) {
        const HandMapping now{.hand = run_->handPosition(),
                              .base = run_->basePosition(),
                              .positionGain = run_->settings().positionGain};
        pointer_->moveTo(pilot_->advance(seconds, now));
    }
    if (spaceMouse_ != nullptr) {
        spaceMouse_->setSpeed(kMouseSpeed * halfWidth);
    }
}

std::string HandControl::deviceStatus() const {
    return spaceMouse_ != nullptr ? spaceMouse_->status() : std::string();
}

}  // namespace asperity
