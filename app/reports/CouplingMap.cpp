#include "app/reports/CouplingMap.h"

#include "core/SiFormat.h"

#include <cmath>
#include <functional>
#include <map>

namespace asperity {

namespace {

/// Told apart with any color vision. Source: Okabe and Ito (2008).
std::vector<ShareKey> couplingKeys() {
    return {{{0, 158, 115}, "settles"},
            {{86, 180, 233}, "settles, but for the detector's noise"},
            {{110, 110, 110}, "refused: no coupling for this rate and delay"},
            {{190, 190, 190}, "refused: contact too stiff, or adhesion too strong, at the device"},
            {{213, 94, 0}, "oscillates"},
            {{0, 0, 0}, "a defect"}};
}

using RowOf = std::function<double(const HoldOutcome&)>;

/// A row of a map: a value and its name.
struct RowChoice {
    std::string label;
    RowOf of;
    const char* unit;
};

double delayOf(const HoldOutcome& hold) { return hold.setting.delay; }

/// Lower end of the decade of the contact's stiffness [N/m].
double decadeOf(const HoldOutcome& hold) {
    return std::pow(10.0, std::floor(std::log10(hold.device.judgment.contact)));
}

/// Every value with its place, smallest first.
std::map<double, std::size_t> placesOf(const std::vector<HoldOutcome>& holds, const RowOf& of) {
    std::map<double, std::size_t> places;
    for (const HoldOutcome& hold : holds) {
        places[of(hold)] = 0;
    }
    std::size_t next = 0;
    for (auto& [value, place] : places) {
        place = next++;
    }
    return places;
}

std::vector<std::string> namesOf(const std::map<double, std::size_t>& places, const char* unit) {
    std::vector<std::string> names;
    for (const auto& [value, place] : places) {
        names.push_back(formatSi(value, unit));
    }
    return names;
}

ShareMap mapOf(const std::vector<HoldOutcome>& holds, bool coupled, const RowChoice& row) {
    const auto columns =
        placesOf(holds, [](const HoldOutcome& hold) { return hold.setting.tickRate; });
    const auto rows = placesOf(holds, row.of);
    ShareMap map{.title = coupled ? "Coupled" : "Not coupled: the device moves the base",
                 .xLabel = "rate of the loop",
                 .yLabel = row.label,
                 .columns = namesOf(columns, "Hz"),
                 .rows = namesOf(rows, row.unit)};
    map.cells.assign(rows.size() * columns.size(),
                     std::vector<double>(kValues<HoldVerdict>.size(), 0.0));
    for (const HoldOutcome& hold : holds) {
        if (hold.setting.coupled == coupled) {
            auto& cell = map.cells[rows.at(row.of(hold)) * columns.size() +
                                   columns.at(hold.setting.tickRate)];
            cell.at(static_cast<std::size_t>(hold.verdict)) += 1.0;
        }
    }
    return map;
}

/// Those that got as far as a contact's stiffness.
std::vector<HoldOutcome> judgedOnes(std::vector<HoldOutcome> holds) {
    std::erase_if(holds,
                  [](const HoldOutcome& hold) { return !(hold.device.judgment.contact > 0.0); });
    return holds;
}

}  // namespace

ShareMapPage couplingMap(const std::vector<HoldOutcome>& holds) {
    const RowChoice delay{"delay from motion to force", delayOf, "s"};
    const RowChoice stiffness{"contact stiffness at the device, from", decadeOf, "N/m"};
    const std::vector<HoldOutcome> judged = judgedOnes(holds);
    ShareMapPage page{.title = "Stability of a device that holds a tip on a sample: every "
                               "sample, lever, scale and grip",
                      .keys = couplingKeys(),
                      .mapsPerRow = 2};
    for (const bool coupled : {true, false}) {
        page.maps.push_back(mapOf(holds, coupled, delay));
    }
    for (const bool coupled : {true, false}) {
        page.maps.push_back(mapOf(judged, coupled, stiffness));
    }
    return page;
}

}  // namespace asperity
