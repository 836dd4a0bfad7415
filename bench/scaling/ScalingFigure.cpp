#include "bench/scaling/ScalingFigure.h"

#include "app/charts/ChartFile.h"
#include "core/FormattedText.h"
#include "vtkplugins/pictures/Palette.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace asperity {

namespace {

std::vector<double> microseconds(const std::vector<double>& times) {
    std::vector<double> shown;
    shown.reserve(times.size());
    for (const double time : times) {
        shown.push_back(1e6 * time);
    }
    return shown;
}

Curve lawOf(const ScalingSweep& sweep, const PowerLaw& law) {
    const double first = sweep.works.front();
    const double last = sweep.works.back();
    return {.label = "",
            .x = {first, last},
            .y = microseconds({law.at(first), law.at(last)}),
            .color = kLightPalette.muted,
            .dashed = true};
}

/// To two digits after the point, without the sign of a zero.
std::string slopeText(double slope) {
    constexpr double kShown = 0.01;
    return formatted("%.2f", std::round(slope / kShown) * kShown + 0.0);
}

Chart chartOf(const ScalingSweep& sweep) {
    Chart chart{.title = "Time against " + sweep.what,
                .xLabel = sweep.what + " [" + sweep.unit + "]",
                .yLabel = "time [µs]",
                .logX = true,
                .logY = true};
    for (std::size_t i = 0; i < sweep.curves.size(); ++i) {
        const ScalingCurve& curve = sweep.curves[i];
        const PowerLaw law = growthOf(sweep, curve);
        chart.curves.push_back(lawOf(sweep, law));
        chart.curves.push_back({.label = curve.name + ": slope " + slopeText(law.exponent),
                                .x = sweep.works,
                                .y = microseconds(curve.times),
                                .color = seriesColor(kLightPalette, i),
                                .points = true});
    }
    chart.curves[0].label = "fitted power law";
    chart.curves[1].pointLabels = sweep.labels;
    return chart;
}

}  // namespace

void writeScalingFigure(const std::filesystem::path& path, std::span<const ScalingSweep> sweeps) {
    std::vector<Chart> charts;
    charts.reserve(sweeps.size());
    for (const ScalingSweep& sweep : sweeps) {
        charts.push_back(chartOf(sweep));
    }
    writePng(path, layOut(charts, {.width = 1800.0, .height = 720.0, .columns = charts.size()}));
}

}  // namespace asperity
