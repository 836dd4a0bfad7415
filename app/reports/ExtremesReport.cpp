#include "app/reports/ExtremesReport.h"

#include "app/reports/CouplingReport.h"
#include "core/FormattedText.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "core/words/ScaleWords.h"

#include <cstdio>
#include <map>
#include <regex>

namespace asperity {

namespace {

void addRegion(CsvWriter& csv, const ExtremesRegion& region) {
    const RegionPlace& place = region.place();
    csv.add(place.model).add(place.setting).add(place.sample);
    csv.add(place.tipRadius).add(place.modulus).add(place.roughness);
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
        const RegionPlace& place = sum.place();
        std::printf("%-11s %-9s %-12s %8ld", place.model.c_str(), place.setting.c_str(),
                    place.sample.c_str(), sum.states());
        for (const Verdict verdict : kValues<Verdict>) {
            std::printf(" %*s", verdict < Verdict::Flagged ? 6 : 8,
                        percent(sum.tally(verdict).states, sum.states()).c_str());
        }
        const VerdictTally worst = sum.unflagged();
        std::printf(" %9.2g %9.2g %9.2g %9.2g\n", worst.force.error, worst.contactRadius.error,
                    worst.jump.error, sum.solver().error);
    }
}

/// How often each kind of refusal was given.
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
                   "jump_error: of the place of snap-in or pull-off, where only one of state and "
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
    const std::vector<ExtremesRegion> sums = summedOverPlaces(findings.regions);
    printModels(sums);
    printHolds(findings.holds);
    printRefusals(findings);
    printVerdicts(sums, findings, seconds);
}

}  // namespace asperity
