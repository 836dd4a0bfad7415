#include "core/haptics/Proxy.h"

#include "core/probe/ProbeSystem.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kComesOnIn = 0.5;       // [s]
constexpr double kMaxGuideStep = 10e-3;  // that a stall counts as [s]

constexpr double kGainTime = 0.1;        // in which a gain changes by a factor of e [s]
constexpr double kMaxProxyStep = 10e-3;  // that a stall counts as [s]

/// The force gain of this tick.
double nextGain(const TickInput& input, double before) {
    const double wanted = input.settings.forceGain;
    if (!(before > 0.0 && wanted > 0.0)) {
        return wanted;
    }
    const double factor = std::exp(std::min(input.timeStep, kMaxProxyStep) / kGainTime);
    return std::clamp(wanted, before / factor, before * factor);
}

ProxyLoad loadOn(const ProxyMemory& memory, const Settings& settings, double forceGain) {
    return {.force = forceGain * memory.load,
            .normal = memory.normal,
            .friction = forceGain * memory.friction,
            .restSpeed = kRestSpeed / settings.positionGain};
}

/// The most that friction gives at all closest points [N].
double largestFriction(const EquilibriumMemory& memory) {
    double friction = 0.0;
    for (std::size_t i = 0; i < memory.pointCount; ++i) {
        friction += memory.points.at(i).friction;
    }
    return friction;
}

}  // namespace

GuideStep stepGuide(const TickInput& input, const Vector3& position,
                    const GuideMemory& memory) noexcept {
    const Settings& settings = input.settings;
    GuideStep step;
    const bool zoomed =
        settings.guide.kind != FixtureKind::None && settings.positionGain != memory.positionGain;
    step.changed = settings.guide != memory.fixture || zoomed;
    if (step.changed) {
        return step;
    }
    const double more = std::min(input.timeStep, kMaxGuideStep) / kComesOnIn;
    step.share = std::min(1.0, memory.share + more);
    VirtualFixture fixture = atDeviceScale(settings.guide, settings.positionGain);
    fixture.forceLimit *= step.share;
    step.force = guide(fixture, position / settings.positionGain, memory.velocity).force;
    return step;
}

GuideMemory guideAfter(const TickInput& input, const GuideStep& step,
                       const Vector3& motion) noexcept {
    return {.fixture = input.settings.guide,
            .positionGain = input.settings.positionGain,
            .share = step.share,
            .velocity = motion / input.timeStep};
}

ProxyStep moveProxy(const TickInput& input, const Vector3& deviceMotion, const GuideStep& guide,
                    const ProxyMemory& memory) noexcept {
    const Settings& settings = input.settings;
    const CouplingGains& gains = settings.coupling;
    if (!gains.couples()) {
        return {.coupling = {.motion = deviceMotion}, .forceGain = settings.forceGain};
    }
    const bool sameSpring = memory.gains == gains && !guide.changed;
    const double forceGain =
        memory.gains.couples() ? nextGain(input, memory.forceGain) : settings.forceGain;
    ProxyLoad load = loadOn(memory, settings, forceGain);
    load.force += guide.force;
    const Vector3 rescaled =
        memory.stretch - (forceGain - memory.forceGain) / gains.stiffness * memory.load;
    const Vector3 stretch = sameSpring ? rescaled : Vector3(-load.force / gains.stiffness);
    return {.coupling = stepCoupling(gains, deviceMotion, stretch, load, input.timeStep),
            .forceGain = forceGain};
}

ProxyMemory proxyAfter(const TickInput& input, const ProxyStep& step, const TipState& state,
                       const EquilibriumMemory& points, const Vector3& correction) noexcept {
    ProxyMemory memory{.stretch = step.coupling.stretch,
                       .gains = input.settings.coupling,
                       .forceGain = step.forceGain};
    if (state.converged && !state.locked) {
        memory.load = state.normalForce * state.normal + correction;
        memory.normal = state.normal;
        memory.friction = largestFriction(points);
    }
    return memory;
}

}  // namespace asperity
