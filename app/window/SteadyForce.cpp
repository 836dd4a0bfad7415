#include "app/window/SteadyForce.h"

#include <algorithm>

namespace asperity {

void SteadyForce::take(const TickSample& sample) noexcept {
    const ForceEstimate& estimate = sample.output.estimate;
    const double step = sample.time - time_;
    const bool begins = isEmpty_ || !(step > 0.0) || sample.output.region() != region_;
    time_ = sample.time;
    region_ = sample.output.region();
    isEmpty_ = !estimate.force.allFinite();
    if (begins) {
        span_ = sample.input.timeStep;
        force_ = estimate.force;
        covariance_ = estimate.covariance;
        return;
    }
    span_ = std::min(span_ + step, period_);
    const double share = std::min(step / span_, 1.0);
    force_ += share * (estimate.force - force_);
    covariance_ += share * (estimate.covariance - covariance_);
}

void SteadyForce::apply(TickOutput& output) const noexcept {
    if (!isEmpty_ && output.region() == region_ && output.estimate.force.allFinite()) {
        output.estimate.force = force_;
        output.estimate.covariance = covariance_;
    }
}

}  // namespace asperity
