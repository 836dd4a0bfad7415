#include "app/reports/ExtremesReport.h"

#include "app/charts/ChartFile.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/Version.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/io/tables/CsvWriter.h"
#include "core/words/DeviceWords.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <utility>

namespace asperity {

namespace {

void addRegion(CsvWriter& csv, const ExtremesRegion& region) {
    const RegionKey& key = region.key();
    csv.add(key.model).add(key.setting).add(key.sample);
    csv.add(key.tipRadius).add(key.modulus).add(key.roughness);
    csv.add(static_cast<double>(region.states()));
    for (const Verdict verdict : kValues<Verdict>) {
        csv.add(static_cast<double>(region.tally(verdict).states));
    }
    const VerdictTally worst = region.unflagged();
    const WorstError& flagged = region.tally(Verdict::Flagged).force;
    csv.add(region.mainReason()).add(region.solver().error);
    csv.add(worst.force.error).add(worst.force.where);
    csv.add(worst.contactRadius.error).add(worst.contactRadius.where);
    csv.add(worst.jump.error).add(worst.jump.where);
    csv.add(flagged.error).add(flagged.where);
}

/// A share of the states for people, 0 only where there is none.
std::string percent(long states, long all) {
    if (states == 0) {
        return "-";
    }
    const double share = 100.0 * static_cast<double>(states) / static_cast<double>(all);
    return formatted("%.3g", share);
}

void printModels(const std::vector<ExtremesRegion>& sums) {
    std::printf("%-11s %-9s %-12s %8s %6s %6s %6s %8s %8s %8s %9s %9s %9s %9s\n", "model",
                "setting", "sample", "states", "exact", "valid", "off", "flagged", "unproven",
                "refused", "force", "radius", "snap-in", "solver");
    std::printf("%-11s %-9s %-12s %8s %6s %6s %6s %8s %8s %8s %9s %9s %9s %9s\n", "", "", "", "",
                "[%]", "[%]", "[%]", "[%]", "[%]", "[%]", "err. max", "err. max", "err. max",
                "err. max");
    for (const ExtremesRegion& sum : sums) {
        const RegionKey& key = sum.key();
        std::printf("%-11s %-9s %-12s %8ld", key.model.c_str(), key.setting.c_str(),
                    key.sample.c_str(), sum.states());
        for (const Verdict verdict : kValues<Verdict>) {
            std::printf(" %*s", verdict < Verdict::Flagged ? 6 : 8,
                        percent(sum.tally(verdict).states, sum.states()).c_str());
        }
        const VerdictTally worst = sum.unflagged();
        std::printf(" %9.2g %9.2g %9.2g %9.2g\n", worst.force.error, worst.contactRadius.error,
                    worst.jump.error, sum.solver().error);
    }
}

/// Counts each kind of refusal.
std::map<std::string, long> refusalsIn(const ExtremesFindings& findings) {
    std::map<std::string, long> refusals;
    for (const ExtremesRegion& region : findings.regions) {
        for (const auto& [reason, states] : region.refusals()) {
            refusals[reason] += states;
        }
    }
    for (const HoldOutcome& hold : findings.holds) {
        if (hold.setting.coupled && !hold.device.holds()) {
            ++refusals["coupling: " + kindOf(refusalOf(hold.device))];
        }
    }
    return refusals;
}

void printRefusals(const ExtremesFindings& findings) {
    std::printf("\nrefused:\n");
    for (const auto& [reason, states] : refusalsIn(findings)) {
        std::printf("%8ld  %s\n", states, reason.c_str());
    }
}

void printVerdicts(const std::vector<ExtremesRegion>& sums, const ExtremesFindings& findings,
                   double seconds) {
    std::printf("\n%ld states in %.3g s; %ld answers of models to them:", findings.states, seconds,
                findings.answers());
    for (const Verdict verdict : kValues<Verdict>) {
        long count = 0;
        for (const ExtremesRegion& sum : sums) {
            count += sum.tally(verdict).states;
        }
        std::printf(" %ld %s", count, nameOf(verdict));
    }
    std::printf("\n");
}

}  // namespace

std::string kindOf(const std::string& sentence) {
    static const std::regex quantity(R"([0-9][0-9.e+-]* \S{0,2}(N/m|N|s)\b)");
    return std::regex_replace(sentence, quantity, "X $1");
}

void writeRegions(const std::filesystem::path& path, const std::vector<ExtremesRegion>& regions) {
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion +
                       ": accuracy of each model, by region; docs/extremes.md",
                   "errors are relative to the reference, or the adhesion's own units where these "
                   "are larger; of states without a flag, but for flagged_force_error",
                   "jump_error: of the snap-in or pull-off position, where only one of state and "
                   "reference has it",
                   "unproven: not flagged, but the reference is not valid there; no errors",
                   "solver_error: maximum, against the exact solver of the same law"},
                  {"model",
                   "tier",
                   "sample",
                   "tip_radius_m",
                   "e_star_pa",
                   "rms_over_tip_radius",
                   "states",
                   "exact",
                   "valid",
                   "off",
                   "flagged",
                   "unproven",
                   "refused",
                   "main_reason",
                   "solver_error",
                   "force_error",
                   "force_error_at",
                   "contact_radius_error",
                   "contact_radius_error_at",
                   "jump_error",
                   "jump_error_at",
                   "flagged_force_error",
                   "flagged_force_error_at"});
    for (const ExtremesRegion& region : regions) {
        addRegion(csv, region);
        csv.endRow();
    }
    csv.close();
}

void printExtremes(const ExtremesFindings& findings, double seconds) {
    const std::vector<ExtremesRegion> sums = summedBySample(findings.regions);
    printModels(sums);
    printHolds(findings.holds);
    printRefusals(findings);
    printVerdicts(sums, findings, seconds);
}

namespace {

/// Devices with and without a coupling.
struct HoldCounts {
    std::array<long, kValues<HoldVerdict>.size()> coupled{};
    std::array<long, kValues<HoldVerdict>.size()> direct{};

    void count(const HoldOutcome& hold) {
        ++(hold.setting.coupled ? coupled : direct)[static_cast<std::size_t>(hold.verdict)];
    }
};

void printCounts(double rate, double delay, const HoldCounts& counts) {
    std::printf("%8.0f %8.0f", rate, 1e3 * delay);
    for (const HoldVerdict verdict :
         {HoldVerdict::Still, HoldVerdict::Noisy, HoldVerdict::NoCoupling,
          HoldVerdict::ScaleTooHigh, HoldVerdict::Oscillates}) {
        std::printf(" %14ld", counts.coupled.at(static_cast<std::size_t>(verdict)));
    }
    for (const HoldVerdict verdict :
         {HoldVerdict::Still, HoldVerdict::Noisy, HoldVerdict::Oscillates}) {
        std::printf(" %14ld", counts.direct.at(static_cast<std::size_t>(verdict)));
    }
    std::printf("\n");
}

}  // namespace

void writeHolds(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds) {
    CsvWriter csv(
        path,
        {std::string("Asperity ") + kVersion +
             ": simulated devices that hold a tip on a sample; docs/extremes.md",
         "contact_n_m: maximum stiffness of lever and contact, at the device; rendered_n_m: "
         "the same in series with the coupling; both 0 where no coupling is offered",
         "scale_holds: result of the stability check; without a coupling it is simulated "
         "regardless"},
        {"material", "work_of_adhesion_j_m2", "lever_n_m", "rate_hz", "delay_s", "position_gain",
         "force_gain", "grip", "coupled", "verdict", "contact_n_m", "rendered_n_m", "scale_holds",
         "swing_m", "refusal"});
    for (const HoldOutcome& hold : holds) {
        const HoldSetting& setting = hold.setting;
        csv.add(setting.material).add(setting.workOfAdhesion).add(setting.leverStiffness);
        csv.add(setting.tickRate).add(setting.delay);
        csv.add(setting.scale.positionGain).add(setting.scale.forceGain);
        csv.add(nameOf(setting.grip)).add(setting.coupled ? 1.0 : 0.0).add(nameOf(hold.verdict));
        const ScaleJudgment& judgment = hold.device.judgment;
        csv.add(judgment.contact).add(judgment.felt).add(hold.device.holds() ? 1.0 : 0.0);
        csv.add(hold.swing).add(refusalOf(hold.device));
        csv.endRow();
    }
    csv.close();
}

void printHolds(const std::vector<HoldOutcome>& holds) {
    std::map<std::pair<double, double>, HoldCounts> counts;
    for (const HoldOutcome& hold : holds) {
        counts[{hold.setting.tickRate, hold.setting.delay}].count(hold);
    }
    std::printf("\n%8s %8s %14s %14s %14s %14s %14s %14s %14s %14s\n", "rate", "delay",
                "coupled:", "", "", "", "", "not coupled:", "", "");
    std::printf("%8s %8s %14s %14s %14s %14s %14s %14s %14s %14s\n", "[Hz]", "[ms]", "still",
                "noisy", "no coupling", "scale too high", "oscillates", "still", "noisy",
                "oscillates");
    for (const auto& [key, count] : counts) {
        printCounts(key.first, key.second, count);
    }
}

namespace {

/// A table of cells, each divided into colored shares of its height.
struct ShareTable {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<std::string> columns;  ///< names, from the left
    std::vector<std::string> rows;     ///< names, from below
    /// By row, then column: a share >= 0 for each key, of whatever total; none: an empty cell.
    std::vector<std::vector<double>> cells;
};

void write(const std::filesystem::path& path, const std::vector<ShareTable>& tables,
           const ChartSheet& sheet) {
    std::vector<Chart> charts;
    for (const ShareTable& table : tables) {
        Chart& chart = charts.emplace_back(Chart{.title = table.title,
                                                 .xLabel = table.xLabel,
                                                 .yLabel = table.yLabel,
                                                 .curves = {},
                                                 .xNames = table.columns,
                                                 .yNames = table.rows});
        for (std::size_t i = 0; i < table.cells.size(); ++i) {
            addShares(chart, i % table.columns.size(), i / table.columns.size(), table.cells[i],
                      sheet.keys);
        }
    }
    writePng(path, layOut(charts, sheet));
}

/// Told apart with any color vision. Source: Okabe and Ito (2008).
std::vector<ChartKey> extremesKeys() {
    return {{{0, 158, 115}, "exact: within 0.1 % of the reference"},
            {{86, 180, 233}, "valid: within 5 %"},
            {{213, 94, 0}, "inaccurate: error above 5 %, not flagged"},
            {{240, 228, 66}, "flagged: not valid, with a flag"},
            {{204, 121, 167}, "unproven: the reference is not valid there"},
            {{110, 110, 110}, "refused, with a reason"}};
}

/// The content of one map.
struct MapChoice {
    std::string model;
    std::string setting;  ///< empty: all
    std::string sample;
    double RegionKey::*row = &RegionKey::modulus;
    std::string (*rowName)(double) = [](double modulus) { return formatSi(modulus, "Pa"); };

    [[nodiscard]] bool has(const RegionKey& key) const {
        return key.model == model && (setting.empty() || key.setting == setting) &&
               key.sample == sample;
    }
};

/// All values of a coordinate, smallest first.
std::vector<double> valuesOf(const std::vector<ExtremesRegion>& regions, const MapChoice& choice,
                             double RegionKey::*coordinate) {
    std::set<double> values;
    for (const ExtremesRegion& region : regions) {
        if (choice.has(region.key())) {
            values.insert(region.key().*coordinate);
        }
    }
    return {values.begin(), values.end()};
}

std::size_t indexOf(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
}

ShareTable mapOf(const std::vector<ExtremesRegion>& regions, const MapChoice& choice) {
    const std::vector<double> columns = valuesOf(regions, choice, &RegionKey::tipRadius);
    const std::vector<double> rows = valuesOf(regions, choice, choice.row);
    ShareTable map{.title = choice.model,
                   .xLabel = "tip radius",
                   .yLabel = "reduced modulus E*",
                   .columns = {},
                   .rows = {},
                   .cells = {}};
    for (const double radius : columns) {
        map.columns.push_back(formatSi(radius, "m"));
    }
    for (const double row : rows) {
        map.rows.push_back(choice.rowName(row));
    }
    map.cells.assign(rows.size() * columns.size(),
                     std::vector<double>(kValues<Verdict>.size(), 0.0));
    for (const ExtremesRegion& region : regions) {
        const RegionKey& key = region.key();
        if (!choice.has(key)) {
            continue;
        }
        auto& cell = map.cells[indexOf(rows, key.*choice.row) * columns.size() +
                               indexOf(columns, key.tipRadius)];
        for (std::size_t i = 0; i < kValues<Verdict>.size(); ++i) {
            cell[i] += static_cast<double>(region.tally(kValues<Verdict>[i]).states);
        }
    }
    return map;
}

ShareTable lawMap(const std::vector<ExtremesRegion>& regions, ContactLaw law) {
    const bool film = isFilm(law);
    ShareTable map =
        mapOf(regions, {.model = keyOf(law), .setting = "", .sample = film ? "film" : "adhesive"});
    map.title = nameOf(law);
    return map;
}

std::string percentOf(double share) { return formatted("%.3g %%", 100.0 * share); }

ShareTable tickMap(const std::vector<ExtremesRegion>& regions) {
    ShareTable map = mapOf(regions, {.model = "tick",
                                     .setting = "certified",
                                     .sample = "rough",
                                     .row = &RegionKey::roughness,
                                     .rowName = percentOf});
    map.title = "Whole tick, auto law";
    map.yLabel = "rms height over tip radius";
    return map;
}

std::vector<ChartKey> couplingKeys() {
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

/// Every value with its index, smallest first.
std::map<double, std::size_t> indicesOf(const std::vector<HoldOutcome>& holds, const RowOf& of) {
    std::map<double, std::size_t> indices;
    for (const HoldOutcome& hold : holds) {
        indices[of(hold)] = 0;
    }
    std::size_t next = 0;
    for (auto& [value, index] : indices) {
        index = next++;
    }
    return indices;
}

std::vector<std::string> namesOf(const std::map<double, std::size_t>& indices, const char* unit) {
    std::vector<std::string> names;
    for (const auto& [value, index] : indices) {
        names.push_back(formatSi(value, unit));
    }
    return names;
}

ShareTable mapOf(const std::vector<HoldOutcome>& holds, bool coupled, const RowChoice& row) {
    const auto columns =
        indicesOf(holds, [](const HoldOutcome& hold) { return hold.setting.tickRate; });
    const auto rows = indicesOf(holds, row.of);
    ShareTable map{.title = coupled ? "Coupled" : "Not coupled: the device moves the base",
                   .xLabel = "rate of the loop",
                   .yLabel = row.label,
                   .columns = namesOf(columns, "Hz"),
                   .rows = namesOf(rows, row.unit),
                   .cells = {}};
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

/// Returns the holds that got as far as a contact's stiffness.
std::vector<HoldOutcome> judgedOnes(std::vector<HoldOutcome> holds) {
    std::erase_if(holds,
                  [](const HoldOutcome& hold) { return !(hold.device.judgment.contact > 0.0); });
    return holds;
}

}  // namespace

void writeExtremesMap(const std::filesystem::path& path,
                      const std::vector<ExtremesRegion>& regions) {
    std::vector<ShareTable> tables;
    for (const ContactLaw law : kValues<ContactLaw>) {
        tables.push_back(lawMap(regions, law));
    }
    tables.push_back(tickMap(regions));
    write(path, tables,
          {.width = 2000.0,
           .height = 1060.0,
           .title =
               "Validity of each contact law: adhesive samples (Hertz on a film: films without "
               "adhesion), every lever and depth; Maugis-Dugdale on the sphere, Hertz on a "
               "film and the tick are their own reference",
           .keys = extremesKeys(),
           .columns = 6,
           .letters = 1.15});
}

void writeCouplingMap(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds) {
    const RowChoice delay{"delay from motion to force", delayOf, "s"};
    const RowChoice stiffness{"contact stiffness at the device, from", decadeOf, "N/m"};
    const std::vector<HoldOutcome> judged = judgedOnes(holds);
    write(path,
          {mapOf(holds, true, delay), mapOf(holds, false, delay), mapOf(judged, true, stiffness),
           mapOf(judged, false, stiffness)},
          {.width = 1400.0,
           .height = 900.0,
           .title =
               "Stability of a device that holds a tip on a sample: every sample, lever, scale "
               "and grip",
           .keys = couplingKeys(),
           .columns = 2,
           .letters = 1.2});
}

}  // namespace asperity
