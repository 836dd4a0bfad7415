#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"
#include "core/surface/leveling/LevelingStep.h"
#include "core/surface/leveling/PlaneFit.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace asperity {

/// Parts that a step removed from the heights. World frame; what a step does not have is 0.
struct RemovedByStep {
    LevelingStep step = LevelingStep::Plane;
    /// Plane of plane, three_point and facet; of quadratic its tangent at the scan's center; of
    /// rows and zero its mean alone: the height that was subtracted from all [m].
    PlaneFit plane;
    double bendX = 0.0;        ///< second derivatives of quadratic [1/m]
    double bendY = 0.0;        ///< [1/m]
    double twist = 0.0;        ///< mixed second derivative [1/m]
    double shiftSpread = 0.0;  ///< standard deviation of the rows' shifts [m]
    std::size_t pixels = 0;    ///< that scars interpolated and marked

    bool operator==(const RemovedByStep&) const = default;
};

/// A map after leveling, and what each step took from it, in order.
template <class Map>
struct LeveledMap {
    Map map;
    std::vector<RemovedByStep> removed;
};

/// Does the steps in order. Pixels without data take part in none; those with a filled height move
/// with their neighbors. A ScanMap's datum is 0 after a step that sets the height of the whole:
/// all but median_of_differences and scars.
/// @param points of three_point
/// @throw Error when the map is unusable, no pixel is valid, or three_point has no positions or bad
///        ones; Canceled
[[nodiscard]] LeveledMap<HeightMap> leveledInSteps(HeightMap map, const LevelingSteps& steps,
                                                   const std::optional<LevelPoints>& points = {},
                                                   Progress* progress = nullptr);
[[nodiscard]] LeveledMap<ScanMap> leveledInSteps(ScanMap map, const LevelingSteps& steps,
                                                 const std::optional<LevelPoints>& points = {},
                                                 Progress* progress = nullptr);

/// The sum of the planes that the steps removed; the bends of quadratic and the shifts of rows are
/// in none.
[[nodiscard]] PlaneFit sumOfPlanes(const std::vector<RemovedByStep>& removed);

/// The map alone. @throw as leveledInSteps()
template <class Map>
[[nodiscard]] Map leveled(Map map, const LevelingSteps& steps,
                          const std::optional<LevelPoints>& points = {},
                          Progress* progress = nullptr) {
    return std::move(leveledInSteps(std::move(map), steps, points, progress).map);
}

}  // namespace asperity
