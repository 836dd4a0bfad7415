#include "app/session/HandControl.h"

#include "app/program/DataFolder.h"
#include "core/haptics/ScriptedHand.h"
#include "core/haptics/bench/SimulatedDevice.h"
#include "core/haptics/device/PointerHand.h"
#include "core/io/scene/WoodenHapticsFile.h"
#include "hardware/spacemouse/SpaceMouse.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"

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

void HandControl::detach() { run_ = nullptr; }

HandKind HandControl::kind() const {
    if (handAs<PointerHand>() != nullptr) {
        return HandKind::Pointer;
    }
    if (handAs<ScriptedHand>() != nullptr) {
        return HandKind::Script;
    }
    if (handAs<SpaceMouse>() != nullptr) {
        return HandKind::SpaceMouse;
    }
    if (handAs<SimulatedDevice>() != nullptr) {
        return HandKind::SimulatedDevice;
    }
    return handAs<WoodenHaptics>() != nullptr ? HandKind::WoodenHaptics : HandKind::Other;
}

void HandControl::use(HandKind kind) {
    switch (kind) {
    case HandKind::Pointer:
        return usePointer();
    case HandKind::SpaceMouse:
        return useSpaceMouse();
    case HandKind::SimulatedDevice:
        return lead(
            [](const Vector3&) { return std::make_unique<SimulatedDevice>(Vector3::Zero()); });
    case HandKind::WoodenHaptics:
        return useWoodenHaptics();
    case HandKind::Script:
    case HandKind::Other:
        break;
    }
}

void HandControl::usePointer() {
    lead([](const Vector3& start) { return std::make_unique<PointerHand>(start); });
}

void HandControl::lead(const MakeLed& make) {
    run_->takeHand([&] {
        std::unique_ptr<LedHand> hand = make(run_->handPosition());
        pilot_ = HandPilot(hand->start());
        return hand;
    });
    piloted_ = &run_->hand();
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
        return std::make_unique<ScriptedHand>(std::move(way), run_->settings().positionGain,
                                              run_->handPosition());
    });
}

HidapiTransport& HandControl::hid() {
    if (!transport_) {
        transport_.emplace();
    }
    return *transport_;
}

void HandControl::useSpaceMouse() {
    HidapiTransport& transport = hid();
    run_->takeHand([&] { return std::make_unique<SpaceMouse>(transport, run_->handPosition()); });
}

void HandControl::useWoodenHaptics() {
    const std::filesystem::path file = dataFolder() / "devices" / "woodenhaptics_2015.toml";
    const WoodenHapticsDescription description = readWoodenHaptics(file);
    HidapiTransport& transport = hid();
    run_->takeHand([&] { return std::make_unique<WoodenHaptics>(transport, description); });
}

LedHand* HandControl::led() const {
    auto* const hand = handAs<LedHand>();
    return hand != nullptr && hand == piloted_ && run_->loop().running() ? hand : nullptr;
}

bool HandControl::isDevice() const {
    return run_ != nullptr && handAs<LedHand>() == nullptr && kind() != HandKind::Script;
}

double HandControl::reach() const {
    return kind() == HandKind::Pointer ? 1.0 : 1.0 / run_->settings().positionGain;
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
    if (auto* const mouse = handAs<SpaceMouse>()) {
        mouse->setSpeed(kMouseSpeed * halfWidth);
    }
}

std::string HandControl::deviceStatus() const {
    if (const auto* const device = handAs<WoodenHaptics>()) {
        return device->status();
    }
    const auto* const mouse = handAs<SpaceMouse>();
    return mouse != nullptr ? mouse->status() : std::string();
}

}  // namespace asperity
