#include "app/recording/RunSurvey.h"

#include <utility>

namespace asperity {

RunSurvey surveyOf(RunPlayback& run, Progress* progress) {
    ForceTrace trace;
    RunEventRecorder events;
    run.play(
        0,
        [&](const TickSample& sample) {
            trace.take(sample);
            events.take(sample);
            return true;
        },
        progress);
    return {.trace = std::move(trace), .events = events.events()};
}

}  // namespace asperity
