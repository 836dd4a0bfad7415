#include "app/reports/run/TouchSection.h"

#include "app/reports/run/MeasuredText.h"
#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

namespace asperity {

namespace {

const char* const kNoReading = "–";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The mean of one reading over the touches that have it. @param key of the reading's budgets
template <class ReadingOf>
std::optional<TouchMean> meanOf(const std::vector<BudgetedTouch>& touches, const char* key,
                                ReadingOf readingOf) {
    std::vector<Reading> readings;
    double model = 0.0;  // the touches share what is open in lever, tip and material
    for (const BudgetedTouch& touch : touches) {
        if (const std::optional<Reading> reading = readingOf(touch.cycle)) {
            readings.push_back(*reading);
            const std::optional<Budget> budget = budgetNamed(touch.budgets, key);
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
    return TouchMean{{mean, std::hypot(std::sqrt(variance), isKnown ? model / count : 0.0)},
                     static_cast<long>(readings.size()),
                     isKnown};
}

/// A column of a table of touches.
struct TouchColumn {
    const char* title;
    const char* unit;
    std::function<std::optional<Reading>(const ContactCycle&)> reading;
    const char* key;  ///< of its budget
};

const std::vector<TouchColumn>& contactColumns() {
    static const std::vector<TouchColumn> kColumns{
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

const std::vector<TouchColumn>& adhesionColumns() {
    static const std::vector<TouchColumn> kColumns{
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
SiScale scaleOfColumn(const TouchColumn& column, const std::vector<BudgetedTouch>& touches) {
    double largest = 0.0;
    for (const BudgetedTouch& touch : touches) {
        if (const std::optional<Reading> reading = column.reading(touch.cycle)) {
            largest = std::max(largest, std::abs(reading->value));
        }
    }
    return siScaleFor(largest, column.unit);
}

/// With the deviation by all inputs, where it is known; else with the noise, and that it is that.
std::string cellOf(const TouchColumn& column, const BudgetedTouch& touch, const SiScale& scale) {
    const std::optional<Reading> reading = column.reading(touch.cycle);
    if (!reading) {
        return kNoReading;
    }
    const std::optional<Budget> budget = budgetNamed(touch.budgets, column.key);
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
    add(cycle.slid, "slid: approach and retract at different places");
    add(cycle.contacts > 1, "several contacts at once");
    add(cycle.interrupted, "a part without a state of the model is left out");
    return remark;
}

using Cells = std::vector<PageCell>;

/// A table with the number of each touch, cells of its own, and the values of the columns.
PageTable tableOf(const std::vector<BudgetedTouch>& touches,
                  const std::vector<TouchColumn>& columns, std::vector<PageColumn> own,
                  const std::function<Cells(const ContactCycle&)>& ownCells) {
    PageTable table;
    table.columns.push_back({"touch", true});
    std::ranges::move(own, std::back_inserter(table.columns));
    std::vector<SiScale> scales;
    for (const TouchColumn& column : columns) {
        scales.push_back(scaleOfColumn(column, touches));
        table.columns.push_back(
            {std::string(column.title) + " [" + scales.back().unit + "]", true});
    }
    for (std::size_t i = 0; i < touches.size(); ++i) {
        Cells row{{std::to_string(i + 1)}};
        std::ranges::move(ownCells(touches[i].cycle), std::back_inserter(row));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            row.push_back({cellOf(columns[c], touches[i], scales[c])});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PageTable contactTable(const std::vector<BudgetedTouch>& touches) {
    constexpr double kMicro = 1e6;
    return tableOf(touches, contactColumns(),
                   {{"time [s]", true}, {"x [µm]", true}, {"y [µm]", true}},
                   [](const ContactCycle& cycle) {
                       return Cells{{formatted("%.3f", cycle.touchTime)},
                                    {formatted("%.4f", kMicro * cycle.place.x())},
                                    {formatted("%.4f", kMicro * cycle.place.y())}};
                   });
}

PageTable adhesionTable(const std::vector<BudgetedTouch>& touches) {
    PageTable table =
        tableOf(touches, adhesionColumns(), {}, [](const ContactCycle&) { return Cells(); });
    const bool hasRemarks = std::ranges::any_of(
        touches, [](const BudgetedTouch& touch) { return !remarkOn(touch.cycle).empty(); });
    if (hasRemarks) {
        table.columns.push_back({"remark"});
        for (std::size_t i = 0; i < touches.size(); ++i) {
            table.rows[i].push_back({remarkOn(touches[i].cycle)});
        }
    }
    return table;
}

bool isLeftOutKnown(const std::vector<BudgetedTouch>& touches) {
    return std::ranges::all_of(touches, [](const BudgetedTouch& touch) {
        return std::ranges::all_of(touch.budgets, [](const CycleBudget& one) {
            return one.budget.unknown != UnknownShares::None || one.budget.isLeftOutKnown();
        });
    });
}

std::string meanSentence(const std::vector<BudgetedTouch>& touches) {
    std::string sentence;
    const auto add = [&](const char* name, const std::optional<TouchMean>& mean, const char* unit) {
        if (mean && mean->touches > 1) {
            sentence += std::string(sentence.empty() ? "" : " ") + name + " of " +
                        std::to_string(mean->touches) +
                        " touches: " + measuredText(mean->reading, unit) +
                        ", mean and standard deviation of one touch, by scatter" +
                        (mean->isModelKnown ? ", model and calibration together." : " alone.");
        }
    };
    add("Pull-off force", pullOffOf(touches), "N");
    add("Work of adhesion", adhesionWorkOf(touches), "J");
    return sentence;
}

}  // namespace

std::vector<BudgetedTouch> budgeted(const Scene& scene, const std::vector<ContactCycle>& cycles) {
    std::vector<BudgetedTouch> touches;
    for (const ContactCycle& cycle : cycles) {
        touches.push_back({cycle, cycleBudgets(scene, cycle)});
    }
    return touches;
}

std::optional<TouchMean> pullOffOf(const std::vector<BudgetedTouch>& touches) {
    return meanOf(touches, "pull_off_force_n",
                  [](const ContactCycle& cycle) { return cycle.pullOffForce(); });
}

std::optional<TouchMean> adhesionWorkOf(const std::vector<BudgetedTouch>& touches) {
    return meanOf(touches, "adhesion_work_j",
                  [](const ContactCycle& cycle) { return cycle.workOfAdhesion(); });
}

double maxIndentationOf(const std::vector<BudgetedTouch>& touches) {
    double largest = 0.0;
    for (const BudgetedTouch& touch : touches) {
        largest = std::max(largest, touch.cycle.maxIndentation.value_or(Reading{}).value);
    }
    return largest;
}

void addTouches(PageContent& page, const std::vector<BudgetedTouch>& touches) {
    page.addHeading("Touches");
    if (touches.empty()) {
        page.addParagraph("The tip never touched the sample in this run.");
        return;
    }
    page.addTable(contactTable(touches));
    page.addTable(adhesionTable(touches));
    if (const std::string means = meanSentence(touches); !means.empty()) {
        page.addParagraph(means);
    }
    page.addParagraph(
        "As the lever signals have it, not as the contact model does. x and y: the tip when the "
        "touch begins, from the lower left corner of the scan. Work of adhesion: area between the "
        "retract curve and zero force, where it pulls; hysteresis: area between approach and "
        "retract. ± is one standard deviation, by noise, model and calibration together; where it "
        "says noise it is that of the signals alone, and what model and calibration leave open is "
        "not known: several contacts at once, a part without a state of the model, or a law that "
        "has no such value there. – means: no such value beyond the noise." +
        std::string(isLeftOutKnown(touches) ? ""
                                            : " What the terms left out change is not known, and "
                                              "not in ±."));
}

}  // namespace asperity
