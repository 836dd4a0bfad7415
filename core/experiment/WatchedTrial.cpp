#include "core/experiment/WatchedTrial.h"

#include <algorithm>

namespace asperity {

namespace {

/// Of an instrument that knows no true tip, that of the model.
Vector3 tipOf(const Snapshot& frame) {
    return frame.trueTip.value_or(frame.sample.output.model.tip);
}

}  // namespace

WatchedTrial::WatchedTrial(const PlannedTrial& plan, const Vector3& target, const Snapshot& begin)
    : begin_(begin.sample.time), newest_(begin.sample) {
    trial_.record.plan = plan;
    trial_.record.start = tipOf(begin);
    trial_.record.target = target;
    trial_.moments.push_back(momentOf(begin.sample, 0.0, tipOf(begin)));
}

void WatchedTrial::take(const TickSample& sample) {
    if (sample.time > begin_) {
        waiting_.push_back({sample.time, sample.output.estimate.force.norm()});
    }
}

double WatchedTrial::largestUpTo(double time) {
    double largest = 0.0;
    while (!waiting_.empty() && waiting_.front().time <= time) {
        largest = std::max(largest, waiting_.front().size);
        waiting_.pop_front();
    }
    return largest;
}

void WatchedTrial::show(const Snapshot& frame) {
    if (frame.sample.time <= newest_.time) {
        return;  // no tick since the frame before
    }
    newest_ = frame.sample;
    TrialMoment moment = momentOf(frame.sample, time(), tipOf(frame));
    moment.largestForce = largestUpTo(frame.sample.time);
    trial_.moments.push_back(moment);
}

DoneTrial WatchedTrial::end(const TrialEnd& end) const {
    DoneTrial done = trial_;
    const Settings& settings = newest_.input.settings;
    done.record.scale = {.positionGain = settings.positionGain, .forceGain = settings.forceGain};
    done.record.coupling = settings.coupling;
    done.record.fault = fault();
    done.record.timedOut = end.timedOut;
    done.record.struckOut = end.struckOut;
    evaluate(done);
    return done;
}

}  // namespace asperity
