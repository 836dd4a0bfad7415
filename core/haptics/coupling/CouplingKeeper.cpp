#include "core/haptics/coupling/CouplingKeeper.h"

#include "core/haptics/mapping/WorkspaceMapping.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kStandardPosition = 1e-6;  // 1 mm : 1 nm
constexpr double kStandardForce = 1e8;      // 1 N : 10 nN
constexpr double kMinForce = 1e5;           // 1 N : 10 uN: less, and nothing is felt
constexpr double kForceStep = 0.8;

// Above it an encoder's step of 30 um is more than 3 nm of the tip: such a gain is for hands in the
// scan's own lengths, like the mouse.
constexpr double kCoarsestPosition = 1e-4;

// Gains are designed for a delay rounded up to this, so that one that creeps up as it is measured
// does not seat the spring anew at every frame [s].
constexpr double kDelayStep = 0.5e-3;

double roundedUp(double delay) {
    constexpr double kRounding = 1e-9;  // of a step: a whole number of them stays as it is
    return kDelayStep * std::ceil(delay / kDelayStep - kRounding);
}

DeviceScale scaleOf(const Settings& knobs) { return {knobs.positionGain, knobs.forceGain}; }

Settings withScale(Settings knobs, const DeviceScale& scale) {
    knobs.positionGain = scale.positionGain;
    knobs.forceGain = scale.forceGain;
    return knobs;
}

GuideLoad guideLoad(const VirtualFixture& guide) {
    return guide.kind == FixtureKind::None
               ? GuideLoad{}
               : GuideLoad{.stiffness = guide.stiffness, .damping = guide.damping};
}

}  // namespace

DeviceRequest CouplingKeeper::request(const Led& led, const Settings& knobs) const {
    return {.device = led.device,
            .timing = {.timeStep = scene_->timeStep(), .delay = led.delay},
            .scale = scaleOf(knobs),
            .own = scene_->settings.coupling,
            .maxForce = knobs.governor.maxForce,
            .guide = guideLoad(knobs.guide),
            .control = knobs.positionControl};
}

CoupledDevice CouplingKeeper::couple(const Led& led, const Settings& knobs) const {
    return coupleDevice(scene_->belief, request(led, knobs));
}

Settings CouplingKeeper::take(Led led, Settings knobs) {
    led.scale = scaleOf(knobs);
    knobs.coupling = led.coupled.gains;
    knobs.workspace = workspaceOf(led.device.workspaceRadius, 0.5 * scene_->timeStep() + led.delay);
    led_ = std::move(led);
    return knobs;
}

/// The scene's scale, or the largest standard one that holds.
Settings CouplingKeeper::fitted(const Led& led, Settings knobs) const {
    const DeviceScale own = scaleOf(scene_->settings);
    knobs = withScale(knobs, own);
    if (own.positionGain <= kCoarsestPosition && couple(led, knobs).holds()) {
        return knobs;
    }
    knobs = withScale(knobs, {kStandardPosition, kStandardForce});
    while (!couple(led, knobs).holds() && kForceStep * knobs.forceGain >= kMinForce) {
        knobs.forceGain *= kForceStep;
    }
    return knobs;
}

Settings CouplingKeeper::release(Settings knobs) {
    if (led_) {
        knobs = withScale(knobs, led_->before);
        knobs.coupling = led_->couplingBefore;
        knobs.workspace = {};
        led_.reset();
    }
    return knobs;
}

Settings CouplingKeeper::takeOver(const DeviceSpecification& device, double delay, Settings knobs) {
    if (!device.rendersForce()) {
        return knobs;
    }
    Led led{.device = device,
            .delay = roundedUp(delay),
            .coupled = {},
            .scale = {},
            .before = scaleOf(knobs),
            .couplingBefore = knobs.coupling};
    knobs = fitted(led, knobs);
    led.coupled = couple(led, knobs);
    if (!led.coupled.holds()) {
        throw CouplingRefused(led.coupled);
    }
    return take(led, knobs);
}

Settings CouplingKeeper::turned(Settings wanted, double delay) {
    if (!led_) {
        return wanted;
    }
    Led led = *led_;
    led.delay = roundedUp(delay);
    led.coupled = couple(led, wanted);
    if (!led.coupled.holds()) {
        if (wanted.forcesOn || scaleOf(wanted) != led_->scale) {
            throw CouplingRefused(led.coupled);
        }
        wanted.coupling = led_->coupled.gains;
        return wanted;
    }
    return take(led, wanted);
}

std::optional<Settings> CouplingKeeper::follow(Settings knobs, double delay) {
    if (!led_ || !(delay > led_->delay)) {
        return std::nullopt;
    }
    Led led = *led_;
    led.delay = roundedUp(delay);
    led.coupled = couple(led, knobs);
    if (led.coupled.holds()) {
        return take(led, knobs);
    }
    led.coupled.gains = led_->coupled.gains;
    led_->delay = led.delay;
    led_->coupled = led.coupled;
    knobs.forcesOn = false;
    return knobs;
}

void CouplingKeeper::requireHolding(const ProbeSystem& tip, const Settings& knobs) const {
    if (led_) {
        const CoupledDevice coupled = coupleDevice(tip, request(*led_, knobs));
        if (!coupled.holds()) {
            throw CouplingRefused(coupled);
        }
    }
}

}  // namespace asperity
