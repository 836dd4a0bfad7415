#pragma once

#include "core/haptics/VirtualRun.h"

#include <array>
#include <optional>

namespace asperity {

/// What is worth telling of a run afterwards. Jumps and indentation are those of the contact model
/// that the operator's side believes, as all of the tick's states are.
struct RunEvents {
    long ticks = 0;
    std::optional<TickSample> beforeSnapIn;
    std::optional<TickSample> snapIn;                ///< first tick of the first contact
    std::optional<TickSample> beforePullOff;         ///< last tick of the last contact
    std::optional<TickSample> pullOff;               ///< first tick after it
    std::optional<TickSample> deepest;               ///< largest indentation
    std::optional<TickSample> strongestPull;         ///< most negative normal force of the model
    double largestForce = 0.0;                       ///< of the model, magnitude [N]
    double largestEstimatedForce = 0.0;              ///< magnitude [N]
    std::array<long, kValidityFlagCount> flagged{};  ///< ticks with each flag
    long faults = 0;  ///< ticks with the force switched off by a fault
};

/// Follows a run tick by tick and keeps its events.
class RunEventRecorder {
public:
    void take(const TickSample& sample);
    [[nodiscard]] const RunEvents& events() const noexcept { return events_; }

private:
    void takeJumps(const TickSample& sample);
    void takeExtremes(const TickSample& sample);

    RunEvents events_;
    std::optional<TickSample> previous_;
};

}  // namespace asperity
