#pragma once

#include "core/experiment/Study.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/TickOutput.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// One trial before it is done.
struct PlannedTrial {
    int number = 0;            ///< in the study, from 1
    int participant = 0;       ///< from 1
    std::size_t task = 0;      ///< of Study::tasks
    std::size_t material = 0;  ///< of Study::materials
    std::size_t lever = 0;     ///< of Study::levers
    std::size_t target = 0;    ///< of Study::targets
    int repeat = 0;            ///< from 1
    int attempt = 1;           ///< one more after each that a fault ended or that was struck out
    double height = 0.0;       ///< of the target above the surface at rest; < 0: below [m]
    std::uint64_t seed = 0;    ///< of all that is random in the trial

    bool operator==(const PlannedTrial&) const = default;
};

/// The same trial once more, with other random numbers.
[[nodiscard]] PlannedTrial again(PlannedTrial trial);

/// Row of a Latin square in which every condition follows every other one equally often; an odd
/// number of conditions needs two squares, 2 count rows.
/// Source: Williams (1949), Australian Journal of Scientific Research A 2, 149.
[[nodiscard]] std::vector<std::size_t> balancedOrder(std::size_t count, std::size_t row);

/// All trials of the participants, one participant after the other: repeats; in each the tasks; in
/// each task the levers; with each lever the materials, so that the material changes after each
/// target. Orders are rows of balanced squares, the next one for each participant and repeat, from
/// rows that the seed draws, over conditions that it has shuffled.
/// The trials of a participant do not depend on how many others there are.
[[nodiscard]] std::vector<PlannedTrial> planTrials(const Study& study, int participants,
                                                   std::uint64_t seed);

/// Start of the tip, and its target [m].
struct TrialPositions {
    Vector3 start;
    Vector3 target;
};

[[nodiscard]] TrialPositions positionsOf(const Study& study, const Scene& scene,
                                         const PlannedTrial& trial);

/// A moment of a trial: of the operator model a hundred times a second, of a person each frame of
/// the window; and its end.
struct TrialMoment {
    double time = 0.0;                      ///< since the trial began [s]
    Vector3 tip = Vector3::Zero();          ///< apex; of a simulated instrument the true one [m]
    Vector3 shown = Vector3::Zero();        ///< as the window shows it [m]
    Vector3 device = Vector3::Zero();       ///< where the device is, in its frame [m]
    Vector3 force = Vector3::Zero();        ///< estimated, of the sample on the tip [N]
    Vector3 deviceForce = Vector3::Zero();  ///< [N]
    double largestForce = 0.0;              ///< of `force` since the moment before, magnitude [N]
};

/// Result of a trial.
struct TrialRecord {
    PlannedTrial plan;
    Vector3 start = Vector3::Zero();   ///< of the tip when it began [m]
    Vector3 target = Vector3::Zero();  ///< [m]
    double error = 0.0;                ///< from the target to the tip at the end [m]
    double errorPercent = 0.0;         ///< that, of the way from the start to the target [%]
    double time = 0.0;                 ///< from the button that began it to that which ended it [s]
    double largestForce = 0.0;         ///< estimated, magnitude [N]
    double handleMotion = 0.0;         ///< of the device in the last half second, to and fro [m]
    bool timedOut = false;             ///< the time limit ended it
    Fault fault = Fault::None;         ///< that ended it: the trial is done again
    std::string struckOut;             ///< why it does not count; empty: it does
    std::string device;                ///< key of what the participant held, see docs/study.md
    DeviceScale scale;                 ///< of the device
    CouplingGains coupling;            ///< none: uncoupled

    /// Returns whether it is part of the results.
    [[nodiscard]] bool counts() const noexcept { return fault == Fault::None && struckOut.empty(); }
};

/// A trial with its moments.
struct DoneTrial {
    TrialRecord record;
    std::vector<TrialMoment> moments;
};

/// The moment of a tick; the largest force is the caller's to say.
/// @param time since the trial began [s]
/// @param tip  where it is, see TrialMoment [m]
[[nodiscard]] TrialMoment momentOf(const TickSample& sample, double time, const Vector3& tip);

/// Fills in what the moments say: error, time, largest force, motion of the handle. The last moment
/// is the end.
/// @throw Error without a moment
void evaluate(DoneTrial& trial);

}  // namespace asperity
