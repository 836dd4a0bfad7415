#include "app/experiment/StudyResults.h"

#include "app/exports/PictureFile.h"
#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/TemporaryFile.h"
#include "core/experiment/StudyStatistics.h"
#include "core/io/tables/CsvWriter.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace asperity {

namespace {

using nlohmann::ordered_json;

void writeStatistics(const std::filesystem::path& path,
                     const std::vector<StudyEstimate>& statistics) {
    CsvWriter table(
        path,
        {"of valid trials; low, high: 95 % confidence; empty: of all",
         "a participant is one value, but for the correlation: docs/study.md"},
        {"quantity", "task", "material", "lever", "count", "mean", "deviation", "low", "high"});
    for (const StudyEstimate& estimate : statistics) {
        table.add(keyOf(estimate.quantity))
            .add(keyOf(estimate.task))
            .add(estimate.material)
            .add(estimate.lever)
            .add(std::to_string(estimate.value.count))
            .add(estimate.value.mean)
            .add(estimate.value.deviation)
            .add(estimate.value.low)
            .add(estimate.value.high);
        table.endRow();
    }
    table.close();
}

void writeFindings(const std::filesystem::path& path, const std::vector<StudyFinding>& findings) {
    CsvWriter table(path, {"findings of Vogl, Ma, Sitti (2005), VII, beside those of this study"},
                    {"paper", "verdict", "ours"});
    for (const StudyFinding& finding : findings) {
        table.add(finding.paper).add(keyOf(finding.verdict)).add(finding.ours);
        table.endRow();
    }
    table.close();
}

/// Returns null for a value that is no number.
ordered_json numberOrNull(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json jsonOf(const StudyEstimate& estimate) {
    return {{"quantity", keyOf(estimate.quantity)},
            {"task", keyOf(estimate.task)},
            {"material", estimate.material},
            {"lever", estimate.lever},
            {"count", estimate.value.count},
            {"mean", numberOrNull(estimate.value.mean)},
            {"deviation", numberOrNull(estimate.value.deviation)},
            {"low", numberOrNull(estimate.value.low)},
            {"high", numberOrNull(estimate.value.high)}};
}

/// Counts the attempts that each fault has ended.
std::map<std::string, int> faultsOf(const std::vector<TrialRecord>& trials) {
    std::map<std::string, int> faults;
    for (const TrialRecord& trial : trials) {
        if (trial.fault != Fault::None) {
            ++faults[keyOf(trial.fault)];
        }
    }
    return faults;
}

ordered_json summaryOf(const ExperimentFolder& folder, const std::vector<StudyEstimate>& statistics,
                       const std::vector<StudyFinding>& findings) {
    const std::vector<TrialRecord>& trials = folder.trials();
    ordered_json json{{"study", folder.study().name},
                      {"attempts", trials.size()},
                      {"counting", std::ranges::count_if(trials, &TrialRecord::counts)},
                      {"timed_out", std::ranges::count_if(trials, &TrialRecord::timedOut)},
                      {"faults", faultsOf(trials)},
                      {"statistics", ordered_json::array()},
                      {"findings", ordered_json::array()}};
    for (const StudyEstimate& estimate : statistics) {
        json["statistics"].push_back(jsonOf(estimate));
    }
    for (const StudyFinding& finding : findings) {
        json["findings"].push_back({{"paper", finding.paper},
                                    {"verdict", keyOf(finding.verdict)},
                                    {"ours", finding.ours}});
    }
    return json;
}

/// A number that is not known is a dash.
std::string numberText(const char* format, double number) {
    return std::isnan(number) ? "–" : formatted(format, number);
}

std::string valueText(const Estimate& value, const char* format) {
    return numberText(format, value.mean) + " (" + numberText(format, value.low) + " to " +
           numberText(format, value.high) + ")";
}

std::string rowText(const StudyEstimate& error, const StudyEstimate& time) {
    return formatted("%-5s %-18s %-20s %s %%; %s s\n", keyOf(error.task),
                     error.material.empty() ? "all" : error.material.c_str(), error.lever.c_str(),
                     valueText(error.value, "%.2f").c_str(), valueText(time.value, "%.1f").c_str());
}

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

void addBar(Chart& chart, double x, const Estimate& value, const Color& color) {
    if (value.count > 1) {
        chart.curves.push_back(
            {.label = {}, .x = {x, x}, .y = {value.low, value.high}, .color = color});
    }
    chart.curves.push_back(
        {.label = {}, .x = {x}, .y = {value.mean}, .color = color, .points = true});
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

void writeStudyResults(const ExperimentFolder& folder) {
    const auto statistics = studyStatistics(folder.study(), folder.trials());
    const auto findings = findingsOf(folder.study(), folder.trials());
    writeStatistics(folder.path() / "statistics.csv", statistics);
    writeFindings(folder.path() / "findings.csv", findings);
    OutputFile summary(folder.path() / "summary.json");
    summary.stream() << jsonText(summaryOf(folder, statistics, findings)) << '\n';
    summary.commit();
}

std::string studyText(const ExperimentFolder& folder) {
    const auto statistics = studyStatistics(folder.study(), folder.trials());
    std::string text = formatted("%-5s %-18s %-20s %-25s  %s\n", "task", "material", "lever",
                                 "error, of the way", "time");
    for (const StudyEstimate& estimate : statistics) {
        const auto time = std::ranges::find_if(statistics, [&](const StudyEstimate& one) {
            return one.quantity == StudyQuantity::Time && one.task == estimate.task &&
                   one.material == estimate.material && one.lever == estimate.lever;
        });
        if (estimate.quantity == StudyQuantity::ErrorPercent && time != statistics.end()) {
            text += rowText(estimate, *time);
        }
    }
    text += "\nfindings of Vogl, Ma, Sitti (2005):\n";
    for (const StudyFinding& finding : findingsOf(folder.study(), folder.trials())) {
        text += formatted("  %-10s %s: %s\n", nameOf(finding.verdict), finding.paper.c_str(),
                          finding.ours.c_str());
    }
    for (const auto& [fault, count] : faultsOf(folder.trials())) {
        text += formatted("%d of %zu attempts ended by %s\n", count, folder.trials().size(),
                          fault.c_str());
    }
    return text;
}

namespace {

struct Measured {
    const char* name;
    double (*of)(const TrialRecord&);
};

constexpr std::array<Measured, 3> kMeasured{
    {{"error_percent", [](const TrialRecord& trial) { return trial.errorPercent; }},
     {"time_s", [](const TrialRecord& trial) { return trial.time; }},
     {"handle_motion_m", [](const TrialRecord& trial) { return trial.handleMotion; }}}};

double shareOfFaults(const std::vector<TrialRecord>& trials, const TrialChoice& choice) {
    double all = 0.0;
    double faults = 0.0;
    for (const TrialRecord& trial : trials) {
        if (choice(trial)) {
            all += 1.0;
            faults += trial.fault != Fault::None ? 1.0 : 0.0;
        }
    }
    return all > 0.0 ? faults / all : 0.0;
}

double meanOf(const std::map<int, double>& means) {
    double sum = 0.0;
    for (const auto& [participant, mean] : means) {
        sum += mean;
    }
    return sum / static_cast<double>(means.size());
}

}  // namespace

std::vector<AidVariant> aidVariants(const Study& study) {
    std::vector<AidVariant> variants{{.name = "as_given", .study = study}};
    const auto add = [&](const char* name, const auto& change) {
        Study other = study;
        change(other.aids);
        if (other != study) {
            variants.push_back({.name = name, .study = std::move(other)});
        }
    };
    add("no_coupling", [](StudyAids& aids) { aids.coupling = false; });
    add("no_forces", [](StudyAids& aids) { aids.forces = false; });
    add("no_deformation", [](StudyAids& aids) { aids.deformation = false; });
    add("point_guide", [](StudyAids& aids) { aids.guide = FixtureKind::Point; });
    return variants;
}

void writeAids(const std::filesystem::path& path, const Study& study,
               const std::vector<AidResult>& results) {
    CsvWriter table(
        path,
        {"difference: of participants' means, less those of the first variant; low, "
         "high: 95 % confidence"},
        {"variant", "task", "quantity", "mean", "difference", "low", "high", "share_of_faults"});
    for (const AidResult& result : results) {
        for (const TaskKind task : {TaskKind::Above, TaskKind::On, TaskKind::Below}) {
            const TrialChoice isOf = [&](const TrialRecord& trial) {
                return study.tasks.at(trial.plan.task).kind == task;
            };
            for (const Measured& measured : kMeasured) {
                const auto own = participantMeans(result.trials, isOf, measured.of);
                if (own.empty()) {
                    continue;
                }
                const Estimate difference = pairedDifference(
                    own, participantMeans(results.front().trials, isOf, measured.of));
                table.add(result.name)
                    .add(keyOf(task))
                    .add(measured.name)
                    .add(meanOf(own))
                    .add(difference.mean)
                    .add(difference.low)
                    .add(difference.high)
                    .add(shareOfFaults(result.trials, isOf));
                table.endRow();
            }
        }
    }
    table.close();
}

void writeStudyFigures(const ExperimentFolder& folder) {
    const Study& study = folder.study();
    std::vector<Chart> forces;
    for (const Cell& cell : cellsOf(study)) {
        forces.push_back(forceChart(folder, cell));
    }
    write(folder, "figure_11", forces, {.width = 1600, .height = 1200});
    const std::vector<StudyEstimate> statistics = studyStatistics(study, folder.trials());
    write(folder, "figure_12",
          meanCharts(study, statistics, "error [% of the travel]", StudyQuantity::ErrorPercent),
          {.width = 1600, .height = 500});
    write(folder, "figure_13", meanCharts(study, statistics, "time [s]", StudyQuantity::Time),
          {.width = 1600, .height = 500});
}

}  // namespace asperity
