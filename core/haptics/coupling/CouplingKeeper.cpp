#include "core/haptics/coupling/CouplingKeeper.h"

#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

CoupledDevice judged(const ProbeSystem& tip, const DeviceRequest& request,
                     const CouplingGains& gains) {
    const double force = std::min(request.device.maxForce, request.maxForce);
    const TipLoad load = tipLoad(tip, force / request.scale.forceGain, request.control);
    return {.gains = gains,
            .judgment = judgeScale(load, request.scale, gains,
                                   {.stiffness = request.device.maxStiffness,
                                    .force = force,
                                    .timeStep = request.timing.timeStep},
                                   request.guide),
            .noCoupling = {}};
}

constexpr double kStandardPosition = 1e-6;  // 1 mm : 1 nm
constexpr double kStandardForce = 1e8;      // 1 N : 10 nN
constexpr double kMinForce = 1e5;           // 1 N : 10 uN: less, and nothing is felt
constexpr double kForceStep = 0.8;

// Above it an encoder's step of 30 um is more than 3 nm of the tip: such a gain is for devices in
// the scan's own lengths, like the mouse.
constexpr double kMaxPositionGain = 1e-4;

// Gains are designed for a delay rounded up to this, so that one that creeps up as it is measured
// does not seat the spring again at every frame [s].
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

CoupledDevice coupleDevice(const ProbeSystem& tip, const DeviceRequest& request) {
    try {
        if (request.own.couples() && holdsHandle(request.own, request.device, request.timing)) {
            if (CoupledDevice own = judged(tip, request, request.own); own.holds()) {
                return own;
            }
        }
        return judged(tip, request, designCoupling(request.device, request.timing));
    } catch (const Error& error) {
        return {.gains = {}, .judgment = {}, .noCoupling = error.what()};
    }
}

DeviceRequest CouplingKeeper::request(const Held& held, const Settings& knobs) const {
    return {.device = held.device,
            .timing = {.timeStep = scene_->timeStep(), .delay = held.delay},
            .scale = scaleOf(knobs),
            .own = scene_->settings.coupling,
            .maxForce = knobs.governor.maxForce,
            .guide = guideLoad(knobs.guide),
            .control = knobs.positionControl};
}

CoupledDevice CouplingKeeper::couple(const Held& held, const Settings& knobs) const {
    return coupleDevice(scene_->belief, request(held, knobs));
}

Settings CouplingKeeper::take(Held held, Settings knobs) {
    held.scale = scaleOf(knobs);
    knobs.coupling = held.coupled.gains;
    knobs.workspace =
        workspaceOf(held.device.workspaceRadius, 0.5 * scene_->timeStep() + held.delay);
    held_ = std::move(held);
    return knobs;
}

/// The scene's scale, or the largest standard one that holds.
Settings CouplingKeeper::fitted(const Held& held, Settings knobs) const {
    const DeviceScale own = scaleOf(scene_->settings);
    knobs = withScale(knobs, own);
    if (own.positionGain <= kMaxPositionGain && couple(held, knobs).holds()) {
        return knobs;
    }
    knobs = withScale(knobs, {kStandardPosition, kStandardForce});
    while (!couple(held, knobs).holds() && kForceStep * knobs.forceGain >= kMinForce) {
        knobs.forceGain *= kForceStep;
    }
    return knobs;
}

Settings CouplingKeeper::release(Settings knobs) {
    if (held_) {
        knobs = withScale(knobs, held_->before);
        knobs.coupling = held_->couplingBefore;
        knobs.workspace = {};
        held_.reset();
    }
    return knobs;
}

Settings CouplingKeeper::takeOver(const DeviceSpecification& device, double delay, Settings knobs) {
    if (!device.rendersForce()) {
        return knobs;
    }
    Held held{.device = device,
              .delay = roundedUp(delay),
              .coupled = {},
              .scale = {},
              .before = scaleOf(knobs),
              .couplingBefore = knobs.coupling};
    knobs = fitted(held, knobs);
    held.coupled = couple(held, knobs);
    if (!held.coupled.holds()) {
        throw CouplingRefused(held.coupled);
    }
    return take(held, knobs);
}

Settings CouplingKeeper::turned(Settings wanted, double delay) {
    if (!held_) {
        return wanted;
    }
    Held held = *held_;
    held.delay = roundedUp(delay);
    held.coupled = couple(held, wanted);
    if (!held.coupled.holds()) {
        if (wanted.forcesOn || scaleOf(wanted) != held_->scale) {
            throw CouplingRefused(held.coupled);
        }
        wanted.coupling = held_->coupled.gains;
        return wanted;
    }
    return take(held, wanted);
}

std::optional<Settings> CouplingKeeper::follow(Settings knobs, double delay) {
    if (!held_ || !(delay > held_->delay)) {
        return std::nullopt;
    }
    Held held = *held_;
    held.delay = roundedUp(delay);
    held.coupled = couple(held, knobs);
    if (held.coupled.holds()) {
        return take(held, knobs);
    }
    held.coupled.gains = held_->coupled.gains;
    held_->delay = held.delay;
    held_->coupled = held.coupled;
    knobs.forcesOn = false;
    return knobs;
}

void CouplingKeeper::requireHolding(const ProbeSystem& tip, const Settings& knobs) const {
    if (held_) {
        const CoupledDevice coupled = coupleDevice(tip, request(*held_, knobs));
        if (!coupled.holds()) {
            throw CouplingRefused(coupled);
        }
    }
}

}  // namespace asperity
