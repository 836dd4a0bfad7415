#include "core/haptics/Proxy.h"

#include "core/probe/Sliding.h"

namespace asperity {

namespace {

ProxyLoad loadOn(const ProxyMemory& memory, const Settings& settings) {
    return {.force = settings.forceGain * memory.load,
            .normal = memory.normal,
            .friction = settings.forceGain * memory.friction,
            .restSpeed = kRestSpeed / settings.positionGain};
}

/// The most that friction gives at all feet [N].
double largestFriction(const EquilibriumMemory& memory) {
    double friction = 0.0;
    for (std::size_t i = 0; i < memory.footCount; ++i) {
        friction += memory.feet.at(i).friction;
    }
    return friction;
}

}  // namespace

CouplingStep moveProxy(const TickInput& input, const Vector3& handMotion, const GuideStep& guide,
                       const ProxyMemory& memory) noexcept {
    const Settings& settings = input.settings;
    const CouplingGains& gains = settings.coupling;
    if (!gains.couples()) {
        return {.motion = handMotion};
    }
    ProxyLoad load = loadOn(memory, settings);
    load.force += guide.force;
    const bool seated =
        memory.gains == gains && memory.forceGain == settings.forceGain && !guide.changed;
    const Vector3 stretch = seated ? memory.stretch : Vector3(-load.force / gains.stiffness);
    return stepCoupling(gains, handMotion, stretch, load, input.timeStep);
}

ProxyMemory proxyAfter(const TickInput& input, const CouplingStep& step, const TipState& state,
                       const EquilibriumMemory& feet, const Vector3& correction) noexcept {
    ProxyMemory memory{.stretch = step.stretch,
                       .gains = input.settings.coupling,
                       .forceGain = input.settings.forceGain};
    if (state.converged && !state.locked) {
        memory.load = state.normalForce * state.normal + correction;
        memory.normal = state.normal;
        memory.friction = largestFriction(feet);
    }
    return memory;
}

}  // namespace asperity
