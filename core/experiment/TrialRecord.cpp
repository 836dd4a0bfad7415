#include "core/experiment/TrialRecord.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// In an order of its own, which a script can repeat to the bit.
double distance(const Vector3& a, const Vector3& b) {
    const Vector3 way = a - b;
    return std::sqrt((way.x() * way.x() + way.y() * way.y()) + way.z() * way.z());
}

/// Between the extremes of each axis, the largest.
double handleMotion(const std::vector<TrialMoment>& moments) {
    constexpr double kLastPart = 0.5;  // [s]
    Vector3 low = moments.back().device;
    Vector3 high = low;
    for (const TrialMoment& moment : moments) {
        if (moment.time >= moments.back().time - kLastPart) {
            low = low.cwiseMin(moment.device);
            high = high.cwiseMax(moment.device);
        }
    }
    return (high - low).maxCoeff();
}

}  // namespace

TrialMoment momentOf(const TickSample& sample, double time, const Vector3& tip) {
    return {.time = time,
            .tip = tip,
            .shown = sample.output.model.tip,
            .device = sample.input.device.position,
            .force = sample.output.estimate.force,
            .deviceForce = sample.output.deviceForce};
}

void evaluate(DoneTrial& trial) {
    if (trial.moments.empty()) {
        throw Error("a trial without a moment has no result");
    }
    TrialRecord& record = trial.record;
    const TrialMoment& end = trial.moments.back();
    record.error = distance(end.tip, record.target);
    record.errorPercent = 100.0 * record.error / distance(record.start, record.target);
    record.time = end.time;
    record.handleMotion = handleMotion(trial.moments);
    record.largestForce = 0.0;
    for (const TrialMoment& moment : trial.moments) {
        record.largestForce = std::max(record.largestForce, moment.largestForce);
    }
}

}  // namespace asperity
