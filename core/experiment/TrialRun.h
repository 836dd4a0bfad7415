#pragma once

#include "core/experiment/Operator.h"
#include "core/experiment/TrialPlan.h"
#include "core/haptics/VirtualRun.h"

#include <deque>
#include <functional>
#include <string>

namespace asperity {

struct Scene;

/// Setup of a trial, besides its plan.
struct TrialSetup {
    const Study& study;
    const Scene& scene;  ///< sceneOf() the trial's material and lever
    OperatorTraits person;
    BenchSetup bench;
};

/// The knobs of a trial: as a device with motors gets them, or without a coupling as the study
/// has them. @throw CouplingRefused where none hold
[[nodiscard]] Settings trialSettings(const Study& study, const Scene& scene,
                                     const BenchSetup& bench, const Vector3& target);

/// Functions that see a trial as a recording does; either may be empty.
struct TrialWatch {
    std::function<void(const TickMemory&)> begin = {};  ///< what its first tick starts from
    TickSink tick = {};                                 ///< every tick
};

/// One trial by the operator model, on a virtual clock: the whole tick with bench, instrument and
/// governor. The same trial gives the same bits.
/// @throw CouplingRefused
[[nodiscard]] DoneTrial runTrial(const TrialSetup& setup, const PlannedTrial& trial,
                                 const TrialWatch& watch = {});

/// End of a person's trial.
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

    /// Returns the time of the newest frame since the trial began [s].
    [[nodiscard]] double time() const noexcept { return newest_.time - begin_; }
    /// A fault that has ended it; Fault::None: none has.
    [[nodiscard]] Fault fault() const noexcept { return newest_.output.fault; }

    /// Returns the result; its end is the newest frame.
    [[nodiscard]] DoneTrial end(const TrialEnd& end) const;

private:
    struct Force {
        double time = 0.0;  ///< of the tick [s]
        double size = 0.0;  ///< [N]
    };
    /// Returns the largest force of the ticks up to a time, and removes them [N].
    [[nodiscard]] double largestUpTo(double time);

    DoneTrial trial_;
    double begin_;  ///< tick time [s]
    TickSample newest_;
    std::deque<Force> waiting_;
};

}  // namespace asperity
