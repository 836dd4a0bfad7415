#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/realtime/LatencyHistogram.h"
#include "core/realtime/PacedThread.h"

#include <optional>

namespace asperity {

/// How well the loop keeps its time. Quantiles are those of the last full second.
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
    /// Where the tip of a simulated instrument really is (apex); only pictures show it [m].
    std::optional<Vector3> trueTip;
};

}  // namespace asperity
