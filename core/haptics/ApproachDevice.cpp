#include "core/haptics/ApproachDevice.h"

#include <utility>

namespace asperity {

ApproachDevice::ApproachDevice(const PlannedApproach& approach, double positionGain)
    : ApproachDevice({{0.0, approach.start}}, approach.plan, positionGain,
                     approach.start / positionGain) {}

ApproachDevice::ApproachDevice(DevicePath leadIn, const ApproachPlan& plan, double positionGain,
                               Vector3 start)
    : leadIn_(std::move(leadIn))
    , approach_(plan, leadIn_.back().position)
    , positionGain_(positionGain)
    , start_(std::move(start)) {}

DeviceState ApproachDevice::advance(double timeStep) noexcept {
    const Vector3 moved = nextBase(timeStep) - leadIn_.front().position;
    if (approach_.hasMeasured() && !measured_) {
        measuredForce_ = approach_.measuredForce();
        measuredDeviation_ = approach_.measuredDeviation();
        measured_ = true;
    }
    blocked_ = approach_.isBlocked();
    engaged_ = approach_.hasEngaged();
    phase_ = approach_.phase();
    return {.position = start_ + moved / positionGain_};
}

Vector3 ApproachDevice::nextBase(double timeStep) noexcept {
    if (std::exchange(started_, true)) {
        time_ += timeStep;
    }
    return time_ < leadIn_.back().time ? positionAt(leadIn_, time_)
                                       : approach_.advance(timeStep, force_, hasEquilibrium_);
}

void ApproachDevice::observe(const TickOutput& output) noexcept {
    force_ = output.estimate.force.z();
    hasEquilibrium_ =
        !output.flags.has(Validity::NotInEquilibrium) && !output.flags.has(Validity::FrictionLock);
}

}  // namespace asperity
