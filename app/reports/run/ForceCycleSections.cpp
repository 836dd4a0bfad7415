#include "app/reports/run/RunSections.h"
#include "core/FormattedText.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/scene/Scene.h"
#include "core/words/BudgetWords.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

const char* const kNoReading = "–";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The mean of one reading over the cycles that have it. @param key of the reading's budgets
template <class ReadingOf>
std::optional<CycleMean> meanOf(const std::vector<BudgetedCycle>& cycles, const char* key,
                                ReadingOf readingOf) {
    std::vector<Reading> readings;
    double model = 0.0;  // the cycles share what is open in lever, tip and material
    for (const BudgetedCycle& entry : cycles) {
        if (const std::optional<Reading> reading = readingOf(entry.cycle)) {
            readings.push_back(*reading);
            const std::optional<Budget> budget = budgetNamed(entry.budgets, key);
            model += budget ? budget->modelAboutValue() : kUnknown;
        }
    }
    if (readings.empty()) {
        return std::nullopt;
    }
    const auto count = static_cast<double>(readings.size());
    double mean = 0.0;
    for (const Reading& reading : readings) {
        mean += reading.value / count;
    }
    double variance = readings.front().sigma * readings.front().sigma;
    if (readings.size() > 1) {
        variance = 0.0;
        for (const Reading& reading : readings) {
            variance += (reading.value - mean) * (reading.value - mean) / (count - 1.0);
        }
    }
    const bool isKnown = std::isfinite(model);
    return CycleMean{{mean, std::hypot(std::sqrt(variance), isKnown ? model / count : 0.0)},
                     static_cast<long>(readings.size()),
                     isKnown};
}

/// A column of a table of force cycles.
struct CycleColumn {
    const char* title;
    const char* unit;
    std::function<std::optional<Reading>(const ContactCycle&)> reading;
    const char* key;  ///< of its budget
};

const std::vector<CycleColumn>& contactColumns() {
    static const std::vector<CycleColumn> kColumns{
        {"max. force", "N", [](const ContactCycle& cycle) { return cycle.maxForce; },
         "max_force_n"},
        {"max. indentation", "m", [](const ContactCycle& cycle) { return cycle.maxIndentation; },
         "max_indentation_m"},
        {"snap-in force", "N", [](const ContactCycle& cycle) { return cycle.snapIn; },
         "snap_in_force_n"},
        {"snap-in at gap", "m",
         [](const ContactCycle& cycle) {
             return cycle.snapIn ? std::optional(cycle.snapInBaseDistance) : std::nullopt;
         },
         "snap_in_distance_m"}};
    return kColumns;
}

const std::vector<CycleColumn>& adhesionColumns() {
    static const std::vector<CycleColumn> kColumns{
        {"pull-off force", "N", [](const ContactCycle& cycle) { return cycle.pullOffForce(); },
         "pull_off_force_n"},
        {"work of adhesion", "J", [](const ContactCycle& cycle) { return cycle.workOfAdhesion(); },
         "adhesion_work_j"},
        {"hysteresis", "J", [](const ContactCycle& cycle) { return cycle.closedHysteresis(); },
         "hysteresis_j"},
        {"contact stiffness", "N/m", [](const ContactCycle& cycle) { return cycle.stiffness; },
         "contact_stiffness_n_m"}};
    return kColumns;
}

/// One for all rows, so that they compare at sight.
SiScale scaleOfColumn(const CycleColumn& column, const std::vector<BudgetedCycle>& cycles) {
    double largest = 0.0;
    for (const BudgetedCycle& entry : cycles) {
        if (const std::optional<Reading> reading = column.reading(entry.cycle)) {
            largest = std::max(largest, std::abs(reading->value));
        }
    }
    return siScaleFor(largest, column.unit);
}

/// With the deviation by all inputs, where it is known; else with the noise, and that it is that.
std::string cellOf(const CycleColumn& column, const BudgetedCycle& entry, const SiScale& scale) {
    const std::optional<Reading> reading = column.reading(entry.cycle);
    if (!reading) {
        return kNoReading;
    }
    const std::optional<Budget> budget = budgetNamed(entry.budgets, column.key);
    if (!budget || !(budget->model() > 0.0)) {
        return noisyText(*reading, scale);
    }
    return measuredText({reading->value, std::hypot(budget->noise, budget->modelAboutValue())},
                        scale);
}

std::string remarkOn(const ContactCycle& cycle) {
    std::string remark;
    const auto add = [&remark](bool holds, const char* words) {
        if (holds) {
            remark += std::string(remark.empty() ? "" : "; ") + words;
        }
    };
    add(cycle.fromStart, "in contact from the start");
    add(!cycle.complete(), "still in contact at the end");
    add(cycle.slid, "slid: approach and retract at different positions");
    add(cycle.contacts > 1, "several contacts at once");
    add(cycle.interrupted, "a part without a state of the model is left out");
    return remark;
}

using Cells = std::vector<PageCell>;

/// A table with the number of each cycle, cells of its own, and the values of the columns.
PageTable tableOf(const std::vector<BudgetedCycle>& cycles, const std::vector<CycleColumn>& columns,
                  std::vector<PageColumn> own,
                  const std::function<Cells(const ContactCycle&)>& ownCells) {
    PageTable table;
    table.columns.push_back({"cycle", true});
    std::ranges::move(own, std::back_inserter(table.columns));
    std::vector<SiScale> scales;
    for (const CycleColumn& column : columns) {
        scales.push_back(scaleOfColumn(column, cycles));
        table.columns.push_back(
            {std::string(column.title) + " [" + scales.back().unit + "]", true});
    }
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        Cells row{{std::to_string(i + 1)}};
        std::ranges::move(ownCells(cycles[i].cycle), std::back_inserter(row));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            row.push_back({cellOf(columns[c], cycles[i], scales[c])});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PageTable contactTable(const std::vector<BudgetedCycle>& cycles) {
    constexpr double kMicro = 1e6;
    return tableOf(cycles, contactColumns(),
                   {{"time [s]", true}, {"x [µm]", true}, {"y [µm]", true}},
                   [](const ContactCycle& cycle) {
                       return Cells{{formatted("%.3f", cycle.touchTime)},
                                    {formatted("%.4f", kMicro * cycle.position.x())},
                                    {formatted("%.4f", kMicro * cycle.position.y())}};
                   });
}

PageTable adhesionTable(const std::vector<BudgetedCycle>& cycles) {
    PageTable table =
        tableOf(cycles, adhesionColumns(), {}, [](const ContactCycle&) { return Cells(); });
    const bool hasRemarks = std::ranges::any_of(
        cycles, [](const BudgetedCycle& entry) { return !remarkOn(entry.cycle).empty(); });
    if (hasRemarks) {
        table.columns.push_back({"remark"});
        for (std::size_t i = 0; i < cycles.size(); ++i) {
            table.rows[i].push_back({remarkOn(cycles[i].cycle)});
        }
    }
    return table;
}

bool isLeftOutKnown(const std::vector<BudgetedCycle>& cycles) {
    return std::ranges::all_of(cycles, [](const BudgetedCycle& entry) {
        return std::ranges::all_of(entry.budgets, [](const CycleBudget& one) {
            return one.budget.unknown != UnknownShares::None || one.budget.isLeftOutKnown();
        });
    });
}

std::string meanSentence(const std::vector<BudgetedCycle>& cycles) {
    std::string sentence;
    const auto add = [&](const char* name, const std::optional<CycleMean>& mean, const char* unit) {
        if (mean && mean->cycles > 1) {
            sentence += std::string(sentence.empty() ? "" : " ") + name + " of " +
                        std::to_string(mean->cycles) +
                        " force cycles: " + measuredText(mean->reading, unit) +
                        ", mean and standard deviation of one, by scatter" +
                        (mean->isModelKnown ? ", model and calibration together." : " alone.");
        }
    };
    add("Pull-off force", pullOffOf(cycles), "N");
    add("Work of adhesion", adhesionWorkOf(cycles), "J");
    return sentence;
}

}  // namespace

std::vector<BudgetedCycle> budgeted(const Scene& scene, const std::vector<ContactCycle>& cycles) {
    std::vector<BudgetedCycle> found;
    for (const ContactCycle& cycle : cycles) {
        found.push_back({cycle, cycleBudgets(scene, cycle)});
    }
    return found;
}

std::optional<CycleMean> pullOffOf(const std::vector<BudgetedCycle>& cycles) {
    return meanOf(cycles, "pull_off_force_n",
                  [](const ContactCycle& cycle) { return cycle.pullOffForce(); });
}

std::optional<CycleMean> adhesionWorkOf(const std::vector<BudgetedCycle>& cycles) {
    return meanOf(cycles, "adhesion_work_j",
                  [](const ContactCycle& cycle) { return cycle.workOfAdhesion(); });
}

double maxIndentationOf(const std::vector<BudgetedCycle>& cycles) {
    double largest = 0.0;
    for (const BudgetedCycle& entry : cycles) {
        largest = std::max(largest, entry.cycle.maxIndentation.value_or(Reading{}).value);
    }
    return largest;
}

void addForceCycles(PageContent& page, const std::vector<BudgetedCycle>& cycles) {
    page.addHeading("Force cycles");
    if (cycles.empty()) {
        page.addParagraph("The tip never touched the sample in this run.");
        return;
    }
    page.addTable(contactTable(cycles));
    page.addTable(adhesionTable(cycles));
    if (const std::string means = meanSentence(cycles); !means.empty()) {
        page.addParagraph(means);
    }
    page.addParagraph(
        "As the lever signals have it, not as the contact model does. x and y: the tip when the "
        "cycle begins, from the lower left corner of the scan. Work of adhesion: area between the "
        "retract curve and zero force, where it pulls; hysteresis: area between approach and "
        "retract. ± is one standard deviation, by noise, model and calibration together; where it "
        "says noise it is that of the signals alone, and that by model and calibration is "
        "not known: several contacts at once, a part without a state of the model, or a law that "
        "has no such value there. – means: no such value beyond the noise." +
        std::string(isLeftOutKnown(cycles) ? ""
                                           : " What the terms left out change is not known, and "
                                             "not in ±."));
}

namespace {

constexpr double kApproachWidth = 1.0;  // [pixel of usual letters]
constexpr double kRetractWidth = 2.0;   // same unit
constexpr double kFreeShare = 0.5;      // of the contact's width, shown of the way before it

void addPoint(Curve& curve, double distance, double force) {
    curve.x.push_back(distance);
    curve.y.push_back(force);
}

/// Both branches of a curve; where they meet they have a point in common.
void fill(Curve& approach, Curve& retract, const CycleTrace& trace) {
    const auto of = [&](CurveBranch branch) -> Curve& {
        return branch == CurveBranch::Approach ? approach : retract;
    };
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const TracePoint& point = trace[i];
        if (i > 0 && trace[i - 1].branch != point.branch) {
            Curve& ended = of(trace[i - 1].branch);
            addPoint(ended, point.baseDistance, point.force);
            addPoint(ended, point.baseDistance, std::numeric_limits<double>::quiet_NaN());
        }
        addPoint(of(point.branch), point.baseDistance, point.force);
    }
}

/// The contacts with some of the free way beside them.
ChartRange wayOf(const std::vector<ForceCycleCurve>& curves) {
    ChartRange way{.low = std::numeric_limits<double>::infinity(),
                   .high = -std::numeric_limits<double>::infinity()};
    for (const ForceCycleCurve& curve : curves) {
        for (std::size_t i = 0; i < curve.trace.size(); ++i) {
            if (curve.trace[i].contact) {
                way.low = std::min(way.low, curve.trace[i].baseDistance);
                way.high = std::max(way.high, curve.trace[i].baseDistance);
            }
        }
    }
    const double free = kFreeShare * (way.high - way.low);
    return {way.low - 0.1 * free, way.high + free};
}

/// Returns whether the tip kept its distance: at rest, or in a single tick.
bool keepsDistance(const RunHistory& history) {
    std::vector<const CycleTrace*> traces{&history.present()};
    for (const ForceCycleCurve& curve : history.curves()) {
        traces.push_back(&curve.trace);
    }
    std::optional<double> first;
    for (const CycleTrace* trace : traces) {
        for (std::size_t i = 0; i < trace->size(); ++i) {
            const double distance = (*trace)[i].baseDistance;
            if (distance != first.value_or(distance)) {
                return false;
            }
            first = distance;
        }
    }
    return true;
}

/// One cycle has two colors, of several each has its own.
void addCurve(Chart& chart, const CycleTrace& trace, std::size_t index, std::size_t count) {
    Curve approach{.label = "", .x = {}, .y = {}, .width = kApproachWidth};
    Curve retract{.label = "", .x = {}, .y = {}, .width = kRetractWidth};
    if (count <= 1) {
        approach.label = nameOf(CurveBranch::Approach);
        retract.label = nameOf(CurveBranch::Retract);
        approach.color = kLightPalette.blue;
        retract.color = kLightPalette.orange;
    } else {
        retract.label = "cycle " + std::to_string(index + 1);
        approach.color = retract.color = seriesColor(kLightPalette, index);
    }
    fill(approach, retract, trace);
    chart.curves.push_back(std::move(approach));
    chart.curves.push_back(std::move(retract));
}

void addRing(Chart& chart, const ContactCycle& cycle) {
    if (const std::optional<Reading> pullOff = cycle.pullOffForce()) {
        chart.curves.push_back({.label = "",
                                .x = {cycle.pullOffBaseDistance},
                                .y = {-pullOff->value},
                                .color = chart.curves.back().color,
                                .rings = true});
    }
}

Chart chartOf(const RunHistory& history) {
    Chart chart{.title = "",
                .xLabel = "gap of the undeflected tip",
                .yLabel = "force along the normal",
                .curves = {},
                .xUnit = "m",
                .yUnit = "N",
                .yHolds = {0.0}};
    const std::vector<ForceCycleCurve>& curves = history.curves();
    if (curves.empty()) {
        addCurve(chart, history.present(), 0, 1);
        return chart;
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        addCurve(chart, curves[i].trace, i, curves.size());
        addRing(chart, curves[i].cycle);
    }
    if (const ChartRange way = wayOf(curves); way.low < way.high) {
        chart.xRange = way;
    }
    return chart;
}

}  // namespace

void addCurves(PageContent& page, const RunHistory& history) {
    const std::size_t cycles = history.events().cycles.size();
    std::string caption =
        "Force along the normal at the contact, estimated from the lever signals; positive: the "
        "sample pushes. The distance is the gap that the tip would have if the lever were not "
        "deflected. Thin: approach, thick: retract, rings: pull-off. A point is the mean of "
        "neighboring ticks.";
    if (cycles > RunHistory::kDrawnCycles) {
        caption += " Of " + std::to_string(cycles) + " force cycles the first " +
                   std::to_string(RunHistory::kDrawnCycles) + " are drawn.";
    }
    page.addHeading("Force–distance curve");
    if (keepsDistance(history)) {
        page.addParagraph("The tip did not move to or from the sample: there is no curve.");
        return;
    }
    page.addPlot(
        {chartOf(history), "Force on the tip over the distance of the undeflected tip", caption});
}

void addUncertainty(PageContent& page, const Scene& scene,
                    const std::vector<BudgetedCycle>& cycles) {
    if (!scene.description.uncertainty.enabled || cycles.empty()) {
        return;
    }
    PageTable table{.columns = {{"cycle", true}, {"What"}, {"Value"}, {"Most by"}}, .rows = {}};
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        for (const auto& [key, name, unit, budget] : cycles[i].budgets) {
            table.rows.push_back(
                {{std::to_string(i + 1)}, {name}, {budgetText(budget, unit)}, {mostBy(budget)}});
        }
    }
    std::vector<std::string> remarks;
    for (const BudgetedCycle& entry : cycles) {
        for (const auto& [key, name, unit, budget] : entry.budgets) {
            const std::string remark = resolutionText(budget, name, scene.description.tolerance);
            if (!remark.empty() && std::ranges::find(remarks, remark) == remarks.end()) {
                remarks.push_back(remark);
            }
        }
    }
    const bool isAllKnown = std::ranges::all_of(cycles, [](const BudgetedCycle& entry) {
        return std::ranges::all_of(entry.budgets, [](const CycleBudget& one) {
            return unknownText(one.budget, one.name).empty();
        });
    });
    page.addHeading("Uncertainty");
    page.addTable(table);
    page.addParagraph(
        "The first deviation is the noise of the signals. The second is from lever, "
        "tip, material, calibration and the step from the scan to the effective "
        "radius, by the scene's section [uncertainty]; in brackets the "
        "inputs that make up most of it. A third, where it matters, is what the "
        "terms do that the model leaves out. All are one standard deviation, about the "
        "value less what it is said to be too high by." +
        std::string(isAllKnown ? ""
                               : " A ? is a deviation that is not known, for the reason beside it; "
                                 "what is stated is then not the whole."));
    for (const std::string& remark : remarks) {
        page.addParagraph(capitalized(remark + "."));
    }
}

}  // namespace asperity
