#include "core/haptics/bench/VirtualBench.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kSubstep = 25e-6;  // [s]: 1/40 of a tick, 1/1000 of the fastest oscillation

/// Velocity after friction took at most `most` from it.
double slowed(double velocity, double most) {
    return std::copysign(std::max(0.0, std::abs(velocity) - most), velocity);
}

constexpr double kReachSpeed = 0.5;  // a third of that at which the governor trips [m/s]

/// `way`, but no longer than `most`.
Vector3 shortened(const Vector3& way, double most) {
    const double length = way.norm();
    return length > most ? Vector3((most / length) * way) : way;
}

}  // namespace

VirtualBench::VirtualBench(const BenchSetup& setup, const Vector3& start)
    : handle_(setup.handle)
    , arm_(setup.arm)
    , delay_(setup.delay)
    , target_(start)
    , position_(start)
    , onTheWay_(static_cast<std::size_t>(std::lround(setup.delay / kSubstep)), Vector3::Zero()) {}

DeviceSpecification VirtualBench::specification() const noexcept {
    return {.maxForce = handle_.maxForce,
            .maxStiffness = handle_.maxStiffness,
            .maxDamping = handle_.maxDamping,
            .effectiveMass = handle_.mass,
            .workspaceRadius = handle_.workspaceRadius,
            .streams = true};
}

DeviceState VirtualBench::advance(double timeStep) noexcept {
    time_ += timeStep;
    for (const auto due = std::llround(time_ / kSubstep); substeps_ < due; ++substeps_) {
        substep();
    }
    if (handle_.resolution == 0.0) {
        return {.position = position_};
    }
    const double step = handle_.resolution;
    return {.position = position_.unaryExpr([=](double x) { return step * std::round(x / step); })};
}

// Spring explicit, dampers implicit, then Coulomb friction takes what is left up to its limit: a
// handle at rest stays until more than friction pulls.
void VirtualBench::substep() noexcept {
    const Vector3 motors = delayed(command_).cwiseMax(-handle_.maxForce).cwiseMin(handle_.maxForce);
    const Vector3 pull = motors + arm_.stiffness * (target_ - position_);
    const double damping = arm_.damping + handle_.viscousFriction;
    const double inertia = handle_.mass + kSubstep * damping;
    const Vector3 free = (handle_.mass * velocity_ + kSubstep * pull) / inertia;
    const double friction = kSubstep * handle_.coulombFriction / inertia;
    velocity_ = free.unaryExpr([=](double v) { return slowed(v, friction); });
    position_ += kSubstep * velocity_;
}

Vector3 VirtualBench::delayed(const Vector3& force) noexcept {
    if (onTheWay_.empty()) {
        return force;
    }
    Vector3 arriving = std::exchange(onTheWay_[oldest_], force);
    oldest_ = (oldest_ + 1) % onTheWay_.size();
    return arriving;
}

SimulatedDevice::SimulatedDevice(const Vector3& start, const BenchSetup& setup)
    : PilotedDevice(start), bench_(setup, start), reach_(start) {}

DeviceState SimulatedDevice::advance(double timeStep) noexcept {
    reach_ += shortened(pilot(timeStep) - reach_, kReachSpeed * timeStep);
    reach_ = shortened(reach_, bench_.specification().workspaceRadius);
    bench_.reachFor(reach_);
    return bench_.advance(timeStep);
}

}  // namespace asperity
