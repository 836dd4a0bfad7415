#include "core/surface/leveling/Leveling.h"

#include "core/Error.h"
#include "core/surface/leveling/CountedPixels.h"
#include "core/surface/leveling/FacetPlane.h"
#include "core/surface/leveling/QuadraticFit.h"
#include "core/surface/leveling/RowAlignment.h"
#include "core/surface/leveling/ScarRemoval.h"
#include "core/surface/leveling/ThreePointPlane.h"
#include "core/surface/leveling/ZeroLevel.h"

#include <utility>

namespace asperity {

namespace {

template <class Heights>
void subtractHeight(BasicHeightMap<Heights>& map, double height) {
    subtract(map, [height](int, int) { return height; });
}

template <class Heights>
void removePlane(BasicHeightMap<Heights>& map, const PlaneFit& plane, RemovedByStep& removed) {
    subtractPlane(map, plane);
    removed.plane = plane;
}

template <class Heights>
void removeRowMedians(BasicHeightMap<Heights>& map, RemovedByStep& removed) {
    const RowShifts medians = rowMedians(map);
    subtractRows(map, medians);
    removed.shiftSpread = spreadOf(medians, map);
    removed.plane.mean = planeOf(map).mean;
    subtractHeight(map, removed.plane.mean);
}

template <class Heights>
void removeDifferenceShifts(BasicHeightMap<Heights>& map, RemovedByStep& removed) {
    const RowShifts shifts = detrendedDifferenceShifts(map);
    subtractRows(map, shifts);
    removed.shiftSpread = spreadOf(shifts, map);
}

template <class Heights>
void removeQuadratic(BasicHeightMap<Heights>& map, RemovedByStep& removed) {
    const QuadraticFit fit(map);
    subtract(map, [&fit](int row, int column) { return fit.at(row, column); });
    removed.plane = {.slopeX = fit.slopeX(),
                     .slopeY = fit.slopeY(),
                     .mean = fit.height(),
                     .centerX = 0.5 * map.sizeX(),
                     .centerY = 0.5 * map.sizeY()};
    removed.bendX = fit.bendX();
    removed.bendY = fit.bendY();
    removed.twist = fit.twist();
}

template <class Heights>
RemovedByStep doStep(BasicHeightMap<Heights>& map, LevelingStep step,
                     const std::optional<LevelPoints>& points, Progress* progress) {
    RemovedByStep removed{.step = step};
    switch (step) {
    case LevelingStep::Plane:
        removePlane(map, planeOf(map), removed);
        break;
    case LevelingStep::Rows:
        removeRowMedians(map, removed);
        break;
    case LevelingStep::ThreePoint:
        if (!points) {
            throw Error("three_point needs three places, level_points_m or --level-points");
        }
        removePlane(map, threePointPlane(map, *points), removed);
        break;
    case LevelingStep::Facet:
        removePlane(map, facetPlane(map, progress), removed);
        break;
    case LevelingStep::Quadratic:
        removeQuadratic(map, removed);
        break;
    case LevelingStep::MedianOfDifferences:
        removeDifferenceShifts(map, removed);
        break;
    case LevelingStep::Scars:
        removed.pixels = removeScars(map);
        break;
    case LevelingStep::Zero:
        removed.plane.mean = lowestHeight(map);
        subtractHeight(map, removed.plane.mean);
        break;
    }
    return removed;
}

bool setsHeight(LevelingStep step) {
    return step != LevelingStep::MedianOfDifferences && step != LevelingStep::Scars;
}

/// What was removed is told with the datum in it. @return the datum that is left [m]
double takeDatum(RemovedByStep& removed, double datum) {
    if (!setsHeight(removed.step)) {
        return datum;
    }
    removed.plane.mean += datum;
    return 0.0;
}

/// @return the datum that is left [m]
template <class Heights>
double doSteps(BasicHeightMap<Heights>& map, double datum, const LevelingSteps& steps,
               const std::optional<LevelPoints>& points, Progress* progress,
               std::vector<RemovedByStep>& removed) {
    requireUsable(map);
    const auto count = static_cast<double>(steps.size());
    for (const LevelingStep step : steps) {
        const auto done = static_cast<double>(removed.size());
        reportTo(progress, done / count);
        ProgressPart part(progress, done / count, (done + 1.0) / count);
        removed.push_back(doStep(map, step, points, &part));
        datum = takeDatum(removed.back(), datum);
    }
    reportTo(progress, 1.0);
    return datum;
}

}  // namespace

PlaneFit sumOfPlanes(const std::vector<RemovedByStep>& removed) {
    PlaneFit sum;
    for (const RemovedByStep& one : removed) {
        if (&one == removed.data()) {
            sum = one.plane;
            continue;
        }
        sum.mean += one.plane.at(sum.centerX, sum.centerY);
        sum.slopeX += one.plane.slopeX;
        sum.slopeY += one.plane.slopeY;
    }
    return sum;
}

LeveledMap<HeightMap> leveledInSteps(HeightMap map, const LevelingSteps& steps,
                                     const std::optional<LevelPoints>& points, Progress* progress) {
    std::vector<RemovedByStep> removed;
    (void)doSteps(map, 0.0, steps, points, progress, removed);
    return {.map = std::move(map), .removed = std::move(removed)};
}

LeveledMap<ScanMap> leveledInSteps(ScanMap map, const LevelingSteps& steps,
                                   const std::optional<LevelPoints>& points, Progress* progress) {
    std::vector<RemovedByStep> removed;
    map.datum = doSteps(map, map.datum, steps, points, progress, removed);
    return {.map = std::move(map), .removed = std::move(removed)};
}

}  // namespace asperity
