#pragma once

#include "core/experiment/TrialRecord.h"
#include "core/haptics/Snapshot.h"

#include <deque>
#include <string>

namespace asperity {

/// What ended a person's trial.
struct TrialEnd {
    bool timedOut = false;  ///< the time limit
    std::string struckOut;  ///< why it does not count; empty: it does
};

/// A trial of a person as it is watched: a moment a frame of the window, and every tick for the
/// forces between them. It begins and ends with a frame.
class WatchedTrial {
public:
    /// @param begin the frame with which it begins
    WatchedTrial(const PlannedTrial& plan, const Vector3& target, const Snapshot& begin);

    /// Every tick, in order; those after the newest frame wait for the next one.
    void take(const TickSample& sample);
    /// A frame, once all ticks up to it have been taken.
    void show(const Snapshot& frame);

    /// Of the newest frame, since the trial began [s].
    [[nodiscard]] double time() const noexcept { return newest_.time - begin_; }
    /// A fault that has ended it; Fault::None: none has.
    [[nodiscard]] Fault fault() const noexcept { return newest_.output.fault; }

    /// What came of it; its end is the newest frame.
    [[nodiscard]] DoneTrial end(const TrialEnd& end) const;

private:
    struct Force {
        double time = 0.0;  ///< of the tick [s]
        double size = 0.0;  ///< [N]
    };
    /// Of the ticks up to a time, which wait no longer [N].
    [[nodiscard]] double largestUpTo(double time);

    DoneTrial trial_;
    double begin_;  ///< tick time [s]
    TickSample newest_;
    std::deque<Force> waiting_;
};

}  // namespace asperity
