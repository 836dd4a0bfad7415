#include "app/recording/RunComparison.h"

#include "app/recording/RunPlayback.h"
#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asperity {

namespace {

/// The force of a run at rising times.
class ForceAt {
public:
    explicit ForceAt(const ForceTrace& trace) : trace_(trace) {}

    /// @param time since the start, no earlier than that of the call before [s]
    /// @return NaN where it is not known [N]
    double operator()(double time) {
        while (next_ + 1 < trace_.size() && trace_.sinceBegin(next_ + 1) <= time) {
            ++next_;
        }
        // Times that mean the same may differ in the last bits; a neighbor that is not known must
        // not count then.
        for (const std::size_t tick : {next_, std::min(next_ + 1, trace_.size() - 1)}) {
            if (std::abs(trace_.sinceBegin(tick) - time) <= RunPlayback::kTimeRounding) {
                return trace_.force()[tick];
            }
        }
        const double from = trace_.sinceBegin(next_);
        const double share = (time - from) / (trace_.sinceBegin(next_ + 1) - from);
        const double force = trace_.force()[next_];
        return force + share * (trace_.force()[next_ + 1] - force);  // std::lerp() may hide NaN
    }

private:
    const ForceTrace& trace_;
    std::size_t next_ = 0;  ///< the last tick that is not later
};

void summarize(RunComparison& comparison) {
    double sum = 0.0;
    double squares = 0.0;
    comparison.largest = comparison.ticks.front();
    for (const ComparedForces& tick : comparison.ticks) {
        const double difference = tick.difference();
        sum += difference;
        squares += difference * difference;
        if (std::abs(difference) > std::abs(comparison.largest.difference())) {
            comparison.largest = tick;
        }
    }
    const auto count = static_cast<double>(comparison.ticks.size());
    comparison.mean = sum / count;
    comparison.rms = std::sqrt(squares / count);
}

}  // namespace

RunComparison compareRuns(const ForceTrace& first, const ForceTrace& second) {
    RunComparison comparison;
    comparison.overlap = std::min(first.duration(), second.duration());
    ForceAt secondForce(second);
    for (std::size_t tick = 0; second.size() > 0 && tick < first.size(); ++tick) {
        const double time = first.sinceBegin(tick);
        if (time > comparison.overlap + RunPlayback::kTimeRounding) {
            break;
        }
        const ComparedForces forces{time, first.force()[tick], secondForce(time)};
        if (std::isfinite(forces.difference())) {
            comparison.ticks.push_back(forces);
        } else {
            ++comparison.excluded;
        }
    }
    if (comparison.ticks.empty()) {
        throw Error("the runs have no moment in which both forces are known");
    }
    summarize(comparison);
    return comparison;
}

}  // namespace asperity
