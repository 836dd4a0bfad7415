#include "app/exports/RunPlots.h"

#include "app/reports/RunCurves.h"
#include "core/FormattedText.h"
#include "vtkplugins/pictures/Palette.h"

#include <cstdint>
#include <limits>

namespace asperity {

namespace {

/// One branch; a sample that is not a number parts its pieces.
Curve branchCurve(const std::vector<CyclePoint>& cycle, CurveBranch branch, const Color& color) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    Curve curve{.label = nameOf(branch), .x = {}, .y = {}, .color = color};
    bool parted = true;
    for (const CyclePoint& at : cycle) {
        if (at.branch != branch) {
            parted = true;
            continue;
        }
        if (parted && !curve.x.empty()) {
            curve.x.push_back(kNothing);
            curve.y.push_back(kNothing);
        }
        parted = false;
        curve.x.push_back(at.point.separation);
        curve.y.push_back(at.point.force);
    }
    return curve;
}

}  // namespace

std::vector<Chart> forceCharts(RunPlayback& run, Progress* progress) {
    RunCurves curves;
    run.play(
        0,
        [&curves](const TickSample& sample) {
            curves.take(sample);
            return true;
        },
        progress);
    return curves.charts();
}

std::vector<CyclePoint> cycleAround(RunPlayback& run, std::size_t tick, Progress* progress) {
    CycleDetector detector;
    std::vector<CyclePoint> cycle;
    std::int64_t number = detector.number();
    std::size_t played = 0;
    run.play(
        0,
        [&](const TickSample& sample) {
            detector.take(sample.time, sample.input, sample.output);
            if (detector.number() != number) {
                if (played > tick) {
                    return false;
                }
                number = detector.number();
                cycle.clear();
            }
            ++played;
            if (hasPoint(sample.output)) {
                cycle.push_back({sample.time, detector.branch(), detector.point()});
            }
            return true;
        },
        progress);
    return cycle;
}

Chart cycleChart(const std::vector<CyclePoint>& cycle, const TickSample& moment) {
    Chart chart{.title = "Force–distance curve",
                .xLabel = "tip–sample separation",
                .yLabel = "normal force",
                .curves = {branchCurve(cycle, CurveBranch::Approach, kLightPalette.blue),
                           branchCurve(cycle, CurveBranch::Retract, kLightPalette.orange)},
                .xUnit = "m",
                .yUnit = "N"};
    if (hasPoint(moment.output)) {
        const ForceDistancePoint point = forceDistancePoint(moment.output);
        chart.curves.push_back({.label = formatted("t = %.3f s", moment.time),
                                .x = {point.separation},
                                .y = {point.force},
                                .color = kLightPalette.ink,
                                .points = true});
    }
    return chart;
}

}  // namespace asperity
