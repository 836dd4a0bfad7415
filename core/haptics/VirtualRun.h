#pragma once

#include "core/haptics/DevicePath.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/probe/AfmController.h"
#include "core/realtime/PacedThread.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace asperity {

/// One tick with its time.
struct TickSample {
    double time = 0.0;  ///< since the run began [s]
    TickInput input;
    TickOutput output;
};

using TickSink = std::function<void(const TickSample&)>;

/// Runs the tick on a virtual clock: the device along `path`, `afm` answering. Every tick goes to
/// `sink`, in order, without a gap.
void runVirtually(const Scene& scene, const DevicePath& path, AfmController& afm, long ticks,
                  const TickSink& sink);
/// The same with a device that only senses; it sees every tick's output, as in the loop.
void runVirtually(const Scene& scene, HapticDevice& device, AfmController& afm, long ticks,
                  const TickSink& sink);

/// Timing statistics of the loop. Quantiles are those of the last full second.
struct LoopStatistics {
    LatencyQuantiles tickTime;  ///< from the device's position to its force [s]
    LatencyQuantiles lateness;  ///< begin of a tick after its due time [s]
    long ticks = 0;             ///< since the loop began
    long overruns = 0;          ///< due times missed and skipped since then
    long lostSamples = 0;       ///< ticks that nobody fetched in time: they miss in logs and curves
    SchedulingPolicy policy = SchedulingPolicy::Ordinary;
};

/// The latest tick as the rest of the program sees it.
struct Snapshot {
    TickSample sample;
    TickMemory memory;  ///< what the tick after it starts from: a replay can begin there
    LoopStatistics statistics;
    /// True position of the tip of a simulated instrument (apex); only pictures show it [m].
    std::optional<Vector3> trueTip;
};

/// Events of a run that are reported afterwards. Jumps and the samples' indentation are those of
/// the contact model that the operator's side believes, as all of the tick's states are; cycles are
/// read from the estimate.
struct RunEvents {
    long ticks = 0;
    bool bondedFromStart =
        false;  ///< the model is in contact in the first tick: no snap-in is seen
    std::optional<TickSample> beforeSnapIn;
    std::optional<TickSample> snapIn;         ///< first tick of the first contact
    std::optional<TickSample> beforePullOff;  ///< last tick of the last contact
    std::optional<TickSample> pullOff;        ///< first tick after it
    /// Last tick of the last contact in which signals and model both hold the tip, see
    /// HoldRecorder; none when the signals never pulled while the model did.
    std::optional<TickSample> lastHold;
    std::optional<TickSample> deepest;               ///< largest indentation
    std::optional<TickSample> strongestPull;         ///< most negative normal force of the model
    double largestForce = 0.0;                       ///< of the model, magnitude [N]
    double largestEstimatedForce = 0.0;              ///< magnitude [N]
    std::array<long, kValidityFlagCount> flagged{};  ///< ticks with each flag
    long faults = 0;  ///< ticks with the force switched off by a fault
    /// As the signals have them, in order; the last one may still be in contact.
    std::vector<ContactCycle> cycles;
};

/// Finds the last moment of a contact in which signals and model both hold the tip. The tip of the
/// instrument and that of the model seldom come off in the same tick, and between the two moments
/// one of them has a force that the other knows nothing of.
///
/// Both hold it while both pull and agree within three standard deviations of the estimate or 20 %
/// of the model, whichever is more. Where they never agree (the sample is not what it is believed
/// to be) it is the tick in which the weaker of the two pulls most.
class HoldRecorder {
public:
    /// Takes a tick of a contact.
    void take(const TickSample& sample);
    /// Returns the last such moment of the ticks taken since the last call; none: no such tick.
    [[nodiscard]] std::optional<TickSample> release();

private:
    std::optional<TickSample> agreeing_;
    std::optional<TickSample> strongest_;
};

/// Follows a run tick by tick and keeps its events.
class RunEventRecorder {
public:
    void take(const TickSample& sample);
    [[nodiscard]] const RunEvents& events() const noexcept { return events_; }

private:
    void takeJumps(const TickSample& sample);
    void takeExtremes(const TickSample& sample);
    void takeCycle(const TickSample& sample);

    RunEvents events_;
    HoldRecorder holds_;
    CycleDetector cycles_;
    std::int64_t lastCycle_ = -1;  ///< number of the newest one in events_
    std::optional<TickSample> previous_;
};

}  // namespace asperity
