#pragma once

#include "app/recording/RecordingThread.h"
#include "app/runs/LiveRun.h"

namespace asperity {

/// A recording of a live run that begins with the tick after its latest one.
class RunRecording {
public:
    /// @param run outlives this @throw Error as Recording
    RunRecording(const RecordingPlace& place, LiveRun& run)
        : RunRecording(place, run, run.loop().snapshot()) {}

    /// Every tick that is fetched; what came before the beginning is left out.
    void take(const TickSample& sample) {
        if (sample.time > after_) {
            thread_.take(sample);
        }
    }
    [[nodiscard]] RecordingThread& thread() noexcept { return thread_; }

private:
    RunRecording(const RecordingPlace& place, LiveRun& run, const Snapshot& before)
        : after_(before.statistics.ticks > 0 ? before.sample.time : -1.0)
        , thread_(place, run.loaded(), before.memory, run.device().delay()) {}

    double after_;  ///< tick time [s]
    RecordingThread thread_;
};

}  // namespace asperity
