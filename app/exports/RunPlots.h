#pragma once

#include "app/recording/RunPlayback.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "vtkplugins/pictures/Charts.h"

#include <vector>

namespace asperity {

/// The charts of forces.png, of all of a run. @throw Canceled
[[nodiscard]] std::vector<Chart> forceCharts(RunPlayback& run, Progress* progress);

/// One tick of a force-distance curve.
struct CyclePoint {
    double time = 0.0;  ///< [s]
    CurveBranch branch = CurveBranch::Approach;
    ForceDistancePoint point;
};

/// The cycle that holds a tick, from where it begins to where the next one does. Ticks without a
/// point (no equilibrium) are left out. @throw Canceled
[[nodiscard]] std::vector<CyclePoint> cycleAround(RunPlayback& run, std::size_t tick,
                                                  Progress* progress);

/// Force over separation, with a dot at a moment.
[[nodiscard]] Chart cycleChart(const std::vector<CyclePoint>& cycle, const TickSample& moment);

}  // namespace asperity
