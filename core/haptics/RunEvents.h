#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/haptics/cycle/CycleDetector.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace asperity {

/// What is worth telling of a run afterwards. Jumps and the samples' indentation are those of the
/// contact model that the operator's side believes, as all of the tick's states are; cycles are
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
    /// Of the ticks taken since the last call.
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
