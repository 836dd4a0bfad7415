#include "app/commands/ExtremesCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/reports/CouplingMap.h"
#include "app/reports/CouplingReport.h"
#include "app/reports/ExtremesMap.h"
#include "app/reports/OutputFolder.h"
#include "core/Error.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "core/studies/extremes/ExtremesStudy.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>

namespace asperity {

namespace {

struct ExtremesOptions {
    std::string out;
    bool force = false;
    double states = 1.1e6;
};

void writeTable(const std::filesystem::path& path, const std::vector<ExtremesRegion>& regions) {
    CsvWriter csv(
        path,
        {std::string("Asperity ") + kVersion +
             ": what the states of each model are worth, by region; docs/extremes.md",
         "errors are relative to the reference, or the adhesion's own units where these "
         "are larger; of states without a flag, but for flagged_force_error",
         "jump_error: of the place of a jump, where only one of state and reference has jumped",
         "unproven: not flagged, but the reference does not hold there; no errors",
         "solver_error: the largest against the same law solved afresh"},
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
        const RegionPlace& place = region.place();
        csv.add(place.model).add(place.tier).add(place.sample);
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
        csv.endRow();
    }
    csv.close();
}

/// A share of the states for people, 0 only where there is none.
std::string percent(long states, long all) {
    if (states == 0) {
        return "-";
    }
    const double share = 100.0 * static_cast<double>(states) / static_cast<double>(all);
    char text[16];
    std::snprintf(text, sizeof text, "%.3g", share);
    return text;
}

void printModels(const std::vector<ExtremesRegion>& sums) {
    std::printf("%-11s %-9s %-12s %8s %6s %6s %6s %8s %8s %8s %9s %9s %9s %9s\n", "model", "tier",
                "sample", "states", "exact", "valid", "off", "flagged", "unproven", "refused",
                "force", "radius", "jump", "solver");
    std::printf("%-11s %-9s %-12s %8s %6s %6s %6s %8s %8s %8s %9s %9s %9s %9s\n", "", "", "", "",
                "[%]", "[%]", "[%]", "[%]", "[%]", "[%]", "err. max", "err. max", "err. max",
                "err. max");
    for (const ExtremesRegion& sum : sums) {
        const RegionPlace& place = sum.place();
        std::printf("%-11s %-9s %-12s %8ld", place.model.c_str(), place.tier.c_str(),
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
        if (hold.setting.coupled && !hold.refusal.empty()) {
            ++refusals["coupling: " + kindOf(hold.refusal)];
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

ExtremesFindings findingsOf(double states) {
    ProgressLine line("evaluating");
    return studyExtremes(ExtremesGrid::ofAbout(states), &line);
}

/// @throw Error where there are any
void reportDefects(const ExtremesFindings& findings) {
    for (const std::string& example : findings.examples) {
        std::fprintf(stderr, "defect: %s\n", example.c_str());
    }
    if (findings.defects > 0) {
        throw Error(std::to_string(findings.defects) + " states have answers that none may have");
    }
}

void extremes(const ExtremesOptions& options) {
    const VirtualDisplay display;  // before anything is written: the map needs it at the end
    OutputFolder out(
        options.out,
        {.own = {"extremes.csv", "coupling.csv", "extremes.png", "coupling.png"}, .guarded = {}},
        options.force);
    const auto start = std::chrono::steady_clock::now();
    const ExtremesFindings findings = findingsOf(options.states);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    out.collect([&](const std::filesystem::path& folder) {
        writeTable(folder / "extremes.csv", findings.regions);
        writeHolds(folder / "coupling.csv", findings.holds);
        writeShareMaps(folder / "extremes.png", extremesMap(findings.regions),
                       {.width = 2000, .height = 1060});
        writeShareMaps(folder / "coupling.png", couplingMap(findings.holds),
                       {.width = 1400, .height = 900});
    });
    out.commit();
    const std::vector<ExtremesRegion> sums = summedOverPlaces(findings.regions);
    printModels(sums);
    printHolds(findings.holds);
    printRefusals(findings);
    printVerdicts(sums, findings, spent.count());
    reportDefects(findings);
}

}  // namespace

void addExtremesCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "extremes",
        "Where each contact law, solver and the whole tick is exact, valid, flagged or "
        "refused, and where a hand holds still, from the softest to the hardest sample");
    const auto options = std::make_shared<ExtremesOptions>();
    addOutputFolder(*command, options->out, "folder for the tables and the maps");
    addForce(*command, options->force);
    command
        ->add_option("--states", options->states,
                     "about how many states of tip, sample, lever and place there are, each "
                     "evaluated with every "
                     "law and solver or every foot search; some are hands on a virtual bench")
        ->check(finiteNumber())
        ->check(CLI::Range(1e4, 1e9))
        ->capture_default_str();
    command->callback([options] { extremes(*options); });
}

}  // namespace asperity
