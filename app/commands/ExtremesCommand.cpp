#include "app/commands/ExtremesCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/program/CancelOnSignal.h"
#include "app/reports/CouplingMap.h"
#include "app/reports/CouplingReport.h"
#include "app/reports/ExtremesMap.h"
#include "app/reports/ExtremesReport.h"
#include "app/runs/OutputFolder.h"
#include "core/Error.h"
#include "core/studies/extremes/ExtremesStudy.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

namespace asperity {

namespace {

struct ExtremesOptions {
    std::string out;
    bool force = false;
    double states = 1.1e6;
};

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
        throw Error(std::to_string(findings.defects) +
                    " states have results that violate an invariant");
    }
}

void extremes(const ExtremesOptions& options) {
    const CancelOnSignal cancel;   // between one piece of work and the next, too
    const VirtualDisplay display;  // before anything is written: the map needs it at the end
    const FolderContent content{.marks = {"extremes.csv"},
                                .own = {"coupling.csv", "extremes.png", "coupling.png"},
                                .guarded = {}};
    requireOutputFolder(options.out, content, options.force);
    const auto start = std::chrono::steady_clock::now();
    const ExtremesFindings findings = findingsOf(options.states);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    OutputFolder out(options.out, content, options.force);
    out.collect([&](const std::filesystem::path& folder) {
        writeRegions(folder / "extremes.csv", findings.regions);
        writeHolds(folder / "coupling.csv", findings.holds);
        writeShareMaps(folder / "extremes.png", extremesMap(findings.regions),
                       {.width = 2000, .height = 1060});
        writeShareMaps(folder / "coupling.png", couplingMap(findings.holds),
                       {.width = 1400, .height = 900});
    });
    out.commit();
    printExtremes(findings, spent.count());
    reportDefects(findings);
}

}  // namespace

void addExtremesCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "extremes",
        "Map accuracy and validity of contact laws, solvers and the haptic loop over the "
        "whole parameter range");
    const auto options = std::make_shared<ExtremesOptions>();
    addOutputFolder(*command, options->out, "folder for the tables and the maps");
    addForce(*command, options->force);
    command
        ->add_option("--states", options->states,
                     "approximate number of states of tip, sample, lever and position, each "
                     "evaluated with every "
                     "law and solver or every closest-point search; some are simulations of a "
                     "coupled device")
        ->check(finiteNumber())
        ->check(CLI::Range(1e4, 1e9))
        ->capture_default_str();
    command->callback([options] { extremes(*options); });
}

}  // namespace asperity
