#include "app/reports/run/TouchSection.h"

#include "app/reports/run/MeasuredText.h"
#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>

namespace asperity {

namespace {

const char* const kNoReading = "–";

std::optional<Reading> workOf(const ContactCycle& cycle) {
    return cycle.pullOff ? std::optional(Reading{cycle.adhesionWork, cycle.areaSigma})
                         : std::nullopt;
}

/// Of the readings that the touches have.
template <class ReadingOf>
std::optional<TouchMean> meanOf(const std::vector<ContactCycle>& cycles, ReadingOf readingOf) {
    std::vector<Reading> readings;
    for (const ContactCycle& cycle : cycles) {
        if (const std::optional<Reading> reading = readingOf(cycle)) {
            readings.push_back(*reading);
        }
    }
    if (readings.size() <= 1) {
        return readings.empty() ? std::nullopt : std::optional(TouchMean{readings.front(), 1});
    }
    const auto count = static_cast<double>(readings.size());
    double mean = 0.0;
    for (const Reading& reading : readings) {
        mean += reading.value / count;
    }
    double variance = 0.0;
    for (const Reading& reading : readings) {
        variance += (reading.value - mean) * (reading.value - mean) / (count - 1.0);
    }
    return TouchMean{{mean, std::sqrt(variance)}, static_cast<long>(readings.size())};
}

/// A column of a table of touches.
struct TouchColumn {
    const char* title;
    const char* unit;
    std::function<std::optional<Reading>(const ContactCycle&)> reading;
};

std::optional<Reading> plain(double value) { return Reading{value, 0.0}; }

const std::vector<TouchColumn>& contactColumns() {
    static const std::vector<TouchColumn> kColumns{
        {"max. force", "N",
         [](const ContactCycle& cycle) { return std::optional(cycle.maxForce); }},
        {"max. indentation", "m",
         [](const ContactCycle& cycle) { return plain(cycle.maxIndentation); }},
        {"snap-in force", "N", [](const ContactCycle& cycle) { return cycle.snapIn; }},
        {"snap-in at gap", "m", [](const ContactCycle& cycle) {
             return cycle.snapIn ? plain(cycle.snapInBaseDistance) : std::nullopt;
         }}};
    return kColumns;
}

const std::vector<TouchColumn>& adhesionColumns() {
    static const std::vector<TouchColumn> kColumns{
        {"pull-off force", "N", [](const ContactCycle& cycle) { return cycle.pullOff; }},
        {"work of adhesion", "J", workOf},
        {"hysteresis", "J", [](const ContactCycle& cycle) { return cycle.closedHysteresis(); }},
        {"contact stiffness", "N/m", [](const ContactCycle& cycle) { return cycle.stiffness; }}};
    return kColumns;
}

/// One for all rows, so that they compare at sight.
SiScale scaleOfColumn(const TouchColumn& column, const std::vector<ContactCycle>& cycles) {
    double largest = 0.0;
    for (const ContactCycle& cycle : cycles) {
        if (const std::optional<Reading> reading = column.reading(cycle)) {
            largest = std::max(largest, std::abs(reading->value));
        }
    }
    return siScaleFor(largest, column.unit);
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
    return remark;
}

using Cells = std::vector<PageCell>;

/// A table with the number of each touch, cells of its own, and the values of the columns.
PageTable tableOf(const std::vector<ContactCycle>& cycles, const std::vector<TouchColumn>& columns,
                  std::vector<PageColumn> own,
                  const std::function<Cells(const ContactCycle&)>& ownCells) {
    PageTable table;
    table.columns.push_back({"touch", true});
    std::ranges::move(own, std::back_inserter(table.columns));
    std::vector<SiScale> scales;
    for (const TouchColumn& column : columns) {
        scales.push_back(scaleOfColumn(column, cycles));
        table.columns.push_back(
            {std::string(column.title) + " [" + scales.back().unit + "]", true});
    }
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        Cells row{{std::to_string(i + 1)}};
        std::ranges::move(ownCells(cycles[i]), std::back_inserter(row));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const std::optional<Reading> reading = columns[c].reading(cycles[i]);
            row.push_back({reading ? measuredText(*reading, scales[c]) : kNoReading});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PageTable contactTable(const std::vector<ContactCycle>& cycles) {
    constexpr double kMicro = 1e6;
    return tableOf(cycles, contactColumns(),
                   {{"time [s]", true}, {"x [µm]", true}, {"y [µm]", true}},
                   [](const ContactCycle& cycle) {
                       return Cells{{formatted("%.3f", cycle.touchTime)},
                                    {formatted("%.4f", kMicro * cycle.place.x())},
                                    {formatted("%.4f", kMicro * cycle.place.y())}};
                   });
}

PageTable adhesionTable(const std::vector<ContactCycle>& cycles) {
    PageTable table =
        tableOf(cycles, adhesionColumns(), {}, [](const ContactCycle&) { return Cells(); });
    const bool hasRemarks = std::ranges::any_of(
        cycles, [](const ContactCycle& cycle) { return !remarkOn(cycle).empty(); });
    if (hasRemarks) {
        table.columns.push_back({"remark"});
        for (std::size_t i = 0; i < cycles.size(); ++i) {
            table.rows[i].push_back({remarkOn(cycles[i])});
        }
    }
    return table;
}

std::string meanSentence(const std::vector<ContactCycle>& cycles) {
    std::string sentence;
    const auto add = [&](const char* name, const std::optional<TouchMean>& mean, const char* unit) {
        if (mean && mean->touches > 1) {
            sentence += std::string(sentence.empty() ? "" : " ") + name + " of " +
                        std::to_string(mean->touches) +
                        " touches: " + measuredText(mean->reading, unit) +
                        ", mean and standard deviation of one touch.";
        }
    };
    add("Pull-off force", pullOffOf(cycles), "N");
    add("Work of adhesion", adhesionWorkOf(cycles), "J");
    return sentence;
}

}  // namespace

std::optional<TouchMean> pullOffOf(const std::vector<ContactCycle>& cycles) {
    return meanOf(cycles, [](const ContactCycle& cycle) { return cycle.pullOff; });
}

std::optional<TouchMean> adhesionWorkOf(const std::vector<ContactCycle>& cycles) {
    return meanOf(cycles, workOf);
}

double maxIndentationOf(const std::vector<ContactCycle>& cycles) {
    double largest = 0.0;
    for (const ContactCycle& cycle : cycles) {
        largest = std::max(largest, cycle.maxIndentation);
    }
    return largest;
}

void addTouches(PageContent& page, const std::vector<ContactCycle>& cycles) {
    page.addHeading("Touches");
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
        "touch begins, from the lower left corner of the scan. Work of adhesion: area between the "
        "retract curve and zero force, where it pulls; hysteresis: area between approach and "
        "retract. ± is one standard deviation from the noise of the signals alone: errors of the "
        "parameters and of the contact model are not in it. A value without ± has none that the "
        "program knows; – means: no such value beyond the noise.");
}

}  // namespace asperity
