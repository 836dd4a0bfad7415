#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RunPlayback.h"
#include "core/haptics/VirtualRun.h"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// The estimated force on the tip along the outward normal: that of the surface, as the contact
/// model found it [N].
[[nodiscard]] double normalForce(const TickOutput& output) noexcept;
/// Its standard deviation [N].
[[nodiscard]] double normalForceSigma(const TickOutput& output) noexcept;

/// The normal force of a run, tick by tick. A tick in which a fault had switched the force off, or
/// whose force or indentation is not a number, has NaN for both.
class ForceTrace {
public:
    /// The next tick.
    void take(const TickSample& sample);
    /// The same by its numbers. @param time later than that of the tick before [s]
    void add(double time, double force, double indentation);

    [[nodiscard]] std::size_t size() const noexcept { return time_.size(); }
    /// Returns the time of the first tick in the run [s]. There is one.
    [[nodiscard]] double begin() const noexcept { return time_.front(); }
    /// Returns the time from the first tick to the last one [s].
    [[nodiscard]] double duration() const noexcept {
        return time_.empty() ? 0.0 : time_.back() - time_.front();
    }
    /// Since the first tick [s].
    [[nodiscard]] double sinceBegin(std::size_t tick) const { return time_[tick] - time_.front(); }
    [[nodiscard]] const std::vector<double>& time() const noexcept { return time_; }    ///< [s]
    [[nodiscard]] const std::vector<double>& force() const noexcept { return force_; }  ///< [N]
    /// Positive into the sample; a gap is negative [m].
    [[nodiscard]] const std::vector<double>& indentation() const noexcept { return indentation_; }

private:
    std::vector<double> time_;
    std::vector<double> force_;
    std::vector<double> indentation_;
};

/// Findings of one pass over every tick of a run.
struct RunSurvey {
    ForceTrace trace;
    RunEvents events;
};

/// Surveys a run. Afterwards any tick is reached within RunPlayback::kCheckpointTicks ticks.
/// @throw Canceled
[[nodiscard]] RunSurvey surveyOf(RunPlayback& run, Progress* progress = nullptr);

/// The normal forces of two runs at the same time since the start of each.
struct ComparedForces {
    double time = 0.0;    ///< since the start [s]
    double first = 0.0;   ///< [N]
    double second = 0.0;  ///< between two ticks linearly interpolated [N]

    [[nodiscard]] double difference() const noexcept { return second - first; }  ///< [N]
};

/// Difference of the normal forces of two runs: second minus
/// first, at the ticks of the first one that lie within both runs.
struct RunComparison {
    std::vector<ComparedForces> ticks;  ///< in order; at least one
    std::size_t excluded = 0;  ///< ticks within both in which one of the forces is not known
    double overlap = 0.0;      ///< for how long both runs last [s]
    double mean = 0.0;         ///< of the differences [N]
    double rms = 0.0;          ///< root of the mean of their squares [N]
    ComparedForces largest;    ///< in magnitude, the first one of equal ones
};

/// Runs may differ in rate and length. Where a force of the second run is not known, none is
/// interpolated over it.
/// @throw Error where no tick is left to compare
[[nodiscard]] RunComparison compareRuns(const ForceTrace& first, const ForceTrace& second);

/// Conditions that a run was made with.
struct RunConditions {
    SceneDescription scene;
    std::string sha256;  ///< of the scan's file; empty: a shape
};

[[nodiscard]] RunConditions conditionsOf(const LoadedScene& loaded);

/// In what the conditions of two runs differ that their forces may follow from, for people, one
/// piece of text each: "scan: a.gsf, channel Height; b.gsf, channel Height",
/// "tip radius_m: 15 nm; 20 nm". Empty: in nothing.
[[nodiscard]] std::vector<std::string> differencesOf(const RunConditions& first,
                                                     const RunConditions& second);

}  // namespace asperity
