#include "app/experiment/StudyFigures.h"

#include "app/exports/PlotFile.h"
#include "core/experiment/StudyStatistics.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <string>

namespace asperity {

namespace {

constexpr int kDrawnRepeat = 1;  // of each participant

std::string titleOf(TaskKind task, const std::string& of) {
    return std::string("Task ") + keyOf(task) + ", " + of;
}

/// A task and a material of a study, and what it is called.
struct Cell {
    TaskKind task;
    std::size_t material;
    std::string title;
};

std::vector<Cell> cellsOf(const Study& study) {
    std::vector<Cell> cells;
    for (const StudyTask& task : study.tasks) {
        for (const std::size_t material : task.materials) {
            cells.push_back({.task = task.kind,
                             .material = material,
                             .title = titleOf(task.kind, study.materials[material].name)});
        }
    }
    return cells;
}

/// The force of one trial that is drawn for each participant.
Chart forceChart(const ExperimentFolder& folder, const Cell& cell) {
    Chart chart{.title = cell.title,
                .xLabel = "time",
                .yLabel = "force, upward",
                .curves = {},
                .xUnit = "s",
                .yUnit = "N"};
    for (const TrialRecord& trial : folder.trials()) {
        if (!trial.counts() || trial.plan.repeat != kDrawnRepeat ||
            trial.plan.material != cell.material ||
            folder.study().tasks.at(trial.plan.task).kind != cell.task) {
            continue;
        }
        Curve curve{.label = {}, .x = {}, .y = {}};
        for (const TrialMoment& moment : folder.momentsOf(trial)) {
            curve.x.push_back(moment.time);
            curve.y.push_back(moment.force.z());
        }
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

void addBar(Chart& chart, double place, const Estimate& value, const Color& color) {
    if (value.count > 1) {
        chart.curves.push_back(
            {.label = {}, .x = {place, place}, .y = {value.low, value.high}, .color = color});
    }
    chart.curves.push_back(
        {.label = {}, .x = {place}, .y = {value.mean}, .color = color, .points = true});
}

/// Means of a task by material, a dot a lever, and their intervals.
Chart meanChart(const Study& study, const std::vector<StudyEstimate>& statistics,
                const StudyTask& task, const std::string& label, StudyQuantity quantity) {
    Chart chart{.title = titleOf(task.kind, nameOf(task.kind)), .xLabel = "", .yLabel = label};
    for (std::size_t i = 0; i < task.materials.size(); ++i) {
        const std::string& material = study.materials[task.materials[i]].name;
        chart.xNames.push_back(material);
        for (std::size_t lever = 0; lever < study.levers.size(); ++lever) {
            const auto found = std::ranges::find_if(statistics, [&](const StudyEstimate& one) {
                return one.quantity == quantity && one.task == task.kind &&
                       one.material == material && one.lever == study.levers[lever].name;
            });
            if (found != statistics.end()) {
                const double middle = 0.5 * (static_cast<double>(study.levers.size()) - 1.0);
                addBar(chart, static_cast<double>(i) + 0.2 * (static_cast<double>(lever) - middle),
                       found->value, seriesColor(kLightPalette, lever));
            }
        }
    }
    return chart;
}

/// All charts over the same heights, 0 among them, so that sizes compare.
void alignHeights(std::vector<Chart>& charts) {
    double lowest = 0.0;
    double highest = 0.0;
    for (const Chart& chart : charts) {
        for (const Curve& curve : chart.curves) {
            lowest = std::min(lowest, std::ranges::min(curve.y));
            highest = std::max(highest, std::ranges::max(curve.y));
        }
    }
    for (Chart& chart : charts) {
        chart.yHolds = {lowest, highest};
    }
}

std::vector<Chart> meanCharts(const Study& study, const std::vector<StudyEstimate>& statistics,
                              const std::string& label, StudyQuantity quantity) {
    std::vector<Chart> charts;
    for (const StudyTask& task : study.tasks) {
        charts.push_back(meanChart(study, statistics, task, label, quantity));
    }
    alignHeights(charts);
    return charts;
}

void write(const ExperimentFolder& folder, const std::string& name,
           const std::vector<Chart>& charts, PictureSize size) {
    const PictureSpec spec{.size = size};
    for (const ExportFormat format : {ExportFormat::Png, ExportFormat::Svg}) {
        writePlotPage(folder.path() / (name + "." + keyOf(format)), charts, spec, format);
    }
}

}  // namespace

void writeStudyFigures(const ExperimentFolder& folder) {
    const Study& study = folder.study();
    std::vector<Chart> forces;
    for (const Cell& cell : cellsOf(study)) {
        forces.push_back(forceChart(folder, cell));
    }
    write(folder, "figure_11", forces, {.width = 1600, .height = 1200});
    const std::vector<StudyEstimate> statistics = studyStatistics(study, folder.trials());
    write(folder, "figure_12",
          meanCharts(study, statistics, "error [% of the way]", StudyQuantity::ErrorPercent),
          {.width = 1600, .height = 500});
    write(folder, "figure_13", meanCharts(study, statistics, "time [s]", StudyQuantity::Time),
          {.width = 1600, .height = 500});
}

}  // namespace asperity
