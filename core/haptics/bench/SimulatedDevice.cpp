#include "core/haptics/bench/SimulatedDevice.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kReachSpeed = 0.5;  // a third of that at which the governor trips [m/s]

/// `way`, but no longer than `most`.
Vector3 shortened(const Vector3& way, double most) {
    const double length = way.norm();
    return length > most ? Vector3((most / length) * way) : way;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const Vector3& start, const BenchSetup& setup)
    : PilotedDevice(start), bench_(setup, start), reach_(start) {}

DeviceState SimulatedDevice::advance(double timeStep) noexcept {
    reach_ += shortened(pilot(timeStep) - reach_, kReachSpeed * timeStep);
    reach_ = shortened(reach_, bench_.specification().workspaceRadius);
    bench_.reachFor(reach_);
    return bench_.advance(timeStep);
}

}  // namespace asperity
