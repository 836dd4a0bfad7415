#include "core/surface/leveling/Leveling.h"

#include "core/Error.h"
#include "core/surface/leveling/CountedPixels.h"
#include "core/surface/leveling/ScarRemoval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// The lowest height of a valid pixel, relative to the map's datum [m].
/// @throw Error when the map is unusable or no pixel is valid; Canceled
template <class Heights>
double lowestHeight(const BasicHeightMap<Heights>& map, Progress* progress) {
    requireUsable(map);
    const double first = firstHeight(map);
    return std::ranges::min(ofEachRow(map.rows, progress, [&](int row) {
        double lowest = first;
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                lowest = std::min(lowest, map.at(row, column));
            }
        }
        return lowest;
    }));
}

/// The two halves of a step: what it measures, and what it takes from the heights.
struct StepProgress {
    explicit StepProgress(Progress* progress)
        : measuring(progress, 0.0, 0.8), subtracting(progress, 0.8, 1.0) {}

    ProgressPart measuring;
    ProgressPart subtracting;
};

template <class Heights>
void subtractHeight(BasicHeightMap<Heights>& map, double height, Progress* progress) {
    subtract(
        map, [height](int, int) { return height; }, progress);
}

template <class Heights>
void removePlane(BasicHeightMap<Heights>& map, const PlaneFit& plane, RemovedByStep& removed,
                 StepProgress& progress) {
    subtractPlane(map, plane, &progress.subtracting);
    removed.plane = plane;
}

template <class Heights>
void removeRowMedians(BasicHeightMap<Heights>& map, RemovedByStep& removed, Progress* progress) {
    ProgressPart measuring(progress, 0.0, 0.6);
    const RowShifts medians = rowMedians(map, &measuring);
    ProgressPart subtracting(progress, 0.6, 0.7);
    subtractRows(map, medians, &subtracting);
    removed.shiftSpread = spreadOf(medians, map);
    ProgressPart leveling(progress, 0.7, 0.9);
    removed.plane.mean = planeOf(map, &leveling).mean;
    ProgressPart lowering(progress, 0.9, 1.0);
    subtractHeight(map, removed.plane.mean, &lowering);
}

template <class Heights>
void removeDifferenceShifts(BasicHeightMap<Heights>& map, RemovedByStep& removed,
                            StepProgress& progress) {
    const RowShifts shifts = detrendedDifferenceShifts(map, &progress.measuring);
    subtractRows(map, shifts, &progress.subtracting);
    removed.shiftSpread = spreadOf(shifts, map);
}

template <class Heights>
void removeQuadratic(BasicHeightMap<Heights>& map, RemovedByStep& removed, StepProgress& progress) {
    const QuadraticFit fit(map, &progress.measuring);
    subtract(
        map, [&fit](int row, int column) { return fit.at(row, column); }, &progress.subtracting);
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
    StepProgress parts(progress);
    switch (step) {
    case LevelingStep::Plane:
        removePlane(map, planeOf(map, &parts.measuring), removed, parts);
        break;
    case LevelingStep::Rows:
        removeRowMedians(map, removed, progress);
        break;
    case LevelingStep::ThreePoint:
        if (!points) {
            throw Error("three_point needs three points, level_points_m or --level-points");
        }
        removePlane(map, threePointPlane(map, *points), removed, parts);
        break;
    case LevelingStep::Facet:
        removePlane(map, facetPlane(map, &parts.measuring), removed, parts);
        break;
    case LevelingStep::Quadratic:
        removeQuadratic(map, removed, parts);
        break;
    case LevelingStep::MedianOfDifferences:
        removeDifferenceShifts(map, removed, parts);
        break;
    case LevelingStep::Scars:
        removed.pixels = removeScars(map, {}, progress);
        break;
    case LevelingStep::Zero:
        removed.plane.mean = lowestHeight(map, &parts.measuring);
        subtractHeight(map, removed.plane.mean, &parts.subtracting);
        break;
    }
    return removed;
}

bool setsHeight(LevelingStep step) {
    return step != LevelingStep::MedianOfDifferences && step != LevelingStep::Scars;
}

/// Returns what was removed is told with the datum in it. @return the datum that is left [m]
double takeDatum(RemovedByStep& removed, double datum) {
    if (!setsHeight(removed.step)) {
        return datum;
    }
    removed.plane.mean += datum;
    return 0.0;
}

/// Largest distance of a height from the map's datum [m]; 0: no pixel holds data. @throw Canceled
template <class Heights>
double largestHeight(const BasicHeightMap<Heights>& map, Progress* progress) {
    return std::ranges::max(ofEachRow(map.rows, progress, [&](int row) {
        double largest = 0.0;
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                largest = std::max(largest, std::abs(static_cast<double>(map.at(row, column))));
            }
        }
        return largest;
    }));
}

/// Makes a map flat of which the steps left nothing but rounding: that has no roughness.
template <class Heights>
void dropRounding(BasicHeightMap<Heights>& map, double before, Progress* progress) {
    using Height = typename Heights::value_type;
    constexpr double kRounding = 8.0 * std::numeric_limits<Height>::epsilon();
    if (largestHeight(map, progress) <= kRounding * before) {
        subtract(
            map, [&map](int row, int column) { return map.at(row, column); }, progress);
    }
}

/// @return the datum that is left [m]
template <class Heights>
double doSteps(BasicHeightMap<Heights>& map, double datum, const LevelingSteps& steps,
               const std::optional<LevelPoints>& points, Progress* progress,
               std::vector<RemovedByStep>& removed) {
    requireUsable(map);
    const auto count = static_cast<double>(steps.size());
    const double before = steps.empty() ? 0.0 : largestHeight(map, nullptr);
    for (const LevelingStep step : steps) {
        const auto done = static_cast<double>(removed.size());
        reportTo(progress, done / count);
        ProgressPart part(progress, done / count, (done + 1.0) / count);
        removed.push_back(doStep(map, step, points, &part));
        datum = takeDatum(removed.back(), datum);
    }
    if (before > 0.0) {
        dropRounding(map, before, nullptr);
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
