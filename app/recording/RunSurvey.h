#pragma once

#include "app/recording/ForceTrace.h"
#include "app/recording/RunPlayback.h"
#include "core/haptics/RunEvents.h"

namespace asperity {

/// What one look at every tick of a run tells.
struct RunSurvey {
    ForceTrace trace;
    RunEvents events;
};

/// From then on any tick of the run is at hand within RunPlayback::kCheckpointTicks ticks.
/// @throw Canceled
[[nodiscard]] RunSurvey surveyOf(RunPlayback& run, Progress* progress = nullptr);

}  // namespace asperity
