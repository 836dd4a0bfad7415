#include "core/haptics/governor/ForceGovernor.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kStretch = 2e-3;   // [s]
constexpr double kRounding = 1e-9;  // of a sum of time steps, relative

/// After a stall one tick may count for many; the force comes on by no more than this at once.
constexpr double kMaxStep = 10e-3;  // [s]

bool isFinite(const TickInput& input, const ForceRequest& request) {
    const GovernorLimits& limits = input.settings.governor;
    return request.force.allFinite() && request.edge.allFinite() &&
           std::isfinite(request.mismatch) && input.device.position.allFinite() &&
           std::isfinite(input.device.maxForce) && std::isfinite(input.device.age) &&
           std::isfinite(limits.maxForce) && std::isfinite(limits.engageTime) &&
           std::isfinite(limits.maxDeviceSpeed);
}

/// The most that device and scene allow [N].
double largestForce(const TickInput& input) {
    return std::min(input.device.maxForce, input.settings.governor.maxForce);
}

Vector3 saturated(const Vector3& force, double largest) {
    const double size = force.stableNorm();
    return size > largest ? Vector3((largest / size) * force) : force;
}

bool holdsDeadMan(const TickInput& input) {
    const int button = input.settings.governor.deadManButton;
    return button == kNoButton || input.device.holds(button);
}

/// Share of the force that the silence of the device leaves: 1 while it reports.
double shareInSilence(const DeviceState& device) {
    if (!device.streams) {
        return 1.0;
    }
    return std::clamp((kSilenceEnd - device.age) / (kSilenceEnd - kSilenceAllowed), 0.0, 1.0);
}

/// The fault of the request, which came first, or one that shows in the device.
Fault faultOf(const TickInput& input, const ForceRequest& request, const GovernorMemory& memory) {
    if (request.fault != Fault::None) {
        return request.fault;
    }
    if (shareInSilence(input.device) == 0.0) {
        return Fault::DeviceSilent;
    }
    const bool acts = memory.share > 0.0 || (memory.edgeShare > 0.0 && !request.edge.isZero(0.0));
    return acts && memory.speed.speed > input.settings.governor.maxDeviceSpeed ? Fault::VelocityTrip
                                                                               : Fault::None;
}

/// Share of a force that acts in this tick, given that nothing forbids it.
/// @param before  that acted in the last one
/// @param wanted  what must be small for the force to come on: the force itself, a mismatch [N]
double nextShare(const TickInput& input, double before, double wanted, double deviceSpeed) {
    const double alive = shareInSilence(input.device);
    if (alive < 1.0) {
        return std::min(before, alive);
    }
    const bool mayComeOn = wanted <= kSmallShare * largestForce(input) &&
                           deviceSpeed <= input.settings.governor.maxDeviceSpeed;
    if (before == 0.0 && !mayComeOn) {
        return 0.0;
    }
    const double step = std::min(input.timeStep, kMaxStep);
    return std::min(1.0, before + step / input.settings.governor.engageTime);
}

/// Returns what keeps the force away, or On.
ForceState permission(const TickInput& input, Fault fault) {
    if (fault != Fault::None) {
        return ForceState::Fault;
    }
    if (!input.settings.forcesOn) {
        return ForceState::Off;
    }
    if (input.device.rendersForce() && !holdsDeadMan(input)) {
        return ForceState::Released;
    }
    return input.clutched() ? ForceState::Clutched : ForceState::On;
}

ForceState stateOf(const TickInput& input, double share, bool limited) {
    if (input.clutched()) {
        return ForceState::Clutched;
    }
    if (share == 0.0) {
        return ForceState::Waiting;
    }
    if (shareInSilence(input.device) < 1.0) {
        return ForceState::Fading;
    }
    if (share < 1.0) {
        return ForceState::Engaging;
    }
    return limited ? ForceState::Limited : ForceState::On;
}

/// For a device that only senses: there is nothing to guard.
GovernedForce passed(const TickInput& input, const ForceRequest& request) {
    const ForceState state = permission(input, request.fault);
    return {.force = state == ForceState::On ? request.force : Vector3(Vector3::Zero()),
            .state = state,
            .fault = request.fault};
}

}  // namespace

SpeedWatch watchSpeed(const SpeedWatch& watch, const Vector3& position, double timeStep) noexcept {
    if (!watch.started) {
        return {.from = position, .started = true};
    }
    SpeedWatch next = watch;
    next.time += timeStep;
    if (next.time >= kStretch * (1.0 - kRounding)) {
        next.speed = (position - watch.from).stableNorm() / next.time;
        next.from = position;
        next.time = 0.0;
    }
    return next;
}

GovernedForce governForce(const TickInput& input, const ForceRequest& request,
                          const GovernorMemory& before) noexcept {
    if (!isFinite(input, request)) {
        const Fault first = request.fault != Fault::None ? request.fault : Fault::NotFinite;
        return {.state = ForceState::Fault, .fault = first};
    }
    if (!input.device.rendersForce()) {
        return passed(input, request);
    }
    GovernorMemory memory =
        before.starts == input.starts ? before : GovernorMemory{.starts = input.starts};
    memory.speed = watchSpeed(memory.speed, input.device.position, input.timeStep);
    const Fault fault = faultOf(input, request, memory);
    const ForceState allowed = permission(input, fault);
    if (allowed != ForceState::On && allowed != ForceState::Clutched) {
        memory.share = 0.0;
        memory.edgeShare = 0.0;
        return {.state = allowed, .fault = fault, .memory = memory};
    }
    const double size = request.force.stableNorm();
    const double speed = memory.speed.speed;
    memory.share = allowed == ForceState::On
                       ? nextShare(input, memory.share, std::max(size, request.mismatch), speed)
                       : 0.0;
    memory.edgeShare = nextShare(input, memory.edgeShare, request.edge.stableNorm(), speed);
    const double largest = largestForce(input);
    const Vector3 sum =
        memory.share * saturated(request.force, largest) + memory.edgeShare * request.edge;
    return {.force = saturated(sum, largest),
            .state = stateOf(input, memory.share, size > largest || sum.stableNorm() > largest),
            .fault = fault,
            .memory = memory};
}

}  // namespace asperity
