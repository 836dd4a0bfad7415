#include "app/session/ExportMoment.h"

#include "app/reports/ContactView.h"
#include "app/reports/RunCurves.h"
#include "core/Error.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/words/SceneWords.h"
#include "ui/Theme.h"
#include "ui/panels/CyclePanel.h"
#include "ui/view/OffscreenZoom.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

Color colorOf(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

void addBranch(Chart& chart, const std::string& label, const QVector<QPointF>& points,
               const QColor& color, bool dashed = false) {
    if (points.size() < 2) {  // a tip that stands still
        return;
    }
    Curve& curve = chart.curves.emplace_back();
    curve.label = label;
    curve.color = colorOf(color);
    curve.dashed = dashed;
    for (const QPointF& point : points) {
        curve.x.push_back(point.x());
        curve.y.push_back(point.y());
    }
}

/// The newest cycle is drawn last, over the others.
Chart cycleChart(const CyclePanel& panel) {
    const theme::LightColors light;
    Chart chart{.title = "Force–distance curve",
                .xLabel = panel.showsBase() ? "base–sample distance" : "tip–sample separation",
                .yLabel = "normal force",
                .curves = {},
                .xUnit = "m",
                .yUnit = "N"};
    const std::string approach = nameOf(CurveBranch::Approach);
    const std::string retract = nameOf(CurveBranch::Retract);
    const std::vector<DrawnCycle>& cycles = panel.plot().cycles();
    for (std::size_t age = cycles.size(); age-- > 0;) {
        const BranchColors colors = branchColors(static_cast<int>(age));
        const std::string which = age == 0 ? "" : ", " + std::to_string(age) + " before";
        addBranch(chart, approach + which, cycles[age].approach, colors.approach);
        addBranch(chart, retract + which, cycles[age].retract, colors.retract);
    }
    const DrawnMeasurement& measured = panel.plot().measured();
    const std::string name = measured.name.toStdString();
    addBranch(chart, name + ", " + approach, measured.approach, theme::colors().ink);
    addBranch(chart, name + ", " + retract, measured.retract, theme::colors().ink, true);
    return chart;
}

std::string nameOf(const SampleDescription& sample) {
    return sample.shape ? sampleName(sample) : std::filesystem::path(sample.file).stem().string();
}

}  // namespace

ExportMoment presentMoment(MainWindow& window, RunControl& runs) {
    auto& panel = *window.findChild<CyclePanel*>();
    panel.refresh();
    const LiveRun& run = *runs.run();
    const TickSample& sample = runs.shown().sample;
    return {.loaded = run.shared(),
            .name = nameOf(run.scene().description.sample),
            .sample = sample,
            .patch = zoomGrid(run.scene(), sample),
            .view = *window.view().shown(),
            .ticks = runs.shownTicks(),
            .cycles = cycleChart(panel),
            .distance = panel.showsBase() ? "base_distance_m" : "separation_m"};
}

OffscreenZoomLook viewLook(const ExportMoment& moment, const PictureSpec& spec) {
    OffscreenZoomLook look = spatialLook(ExportView::Spatial, spec);
    look.shown = moment.view;
    return look;
}

RasterImage viewImage(const ExportMoment& moment, const PictureSpec& spec) {
    return OffscreenZoom(moment.loaded->scene, viewLook(moment, spec)).draw(moment.sample, {});
}

std::vector<Chart> chartsOf(const ExportMoment& moment, ExportSubject subject) {
    if (subject == ExportSubject::Cycle) {
        if (moment.cycles.curves.empty()) {
            throw Error("There is no force–distance curve yet: bring the tip to the sample first.");
        }
        return {moment.cycles};
    }
    if (moment.ticks.empty()) {
        throw Error("There are no forces to plot yet: start the run first.");
    }
    RunCurves curves;
    for (const TickSample& sample : moment.ticks) {
        curves.take(sample);
    }
    std::vector<Chart> charts = curves.charts();
    std::erase_if(charts, [](const Chart& chart) { return chart.xUnit != "s"; });
    return charts;
}

}  // namespace asperity
