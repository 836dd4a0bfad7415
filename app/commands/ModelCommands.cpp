#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/program/DataFolder.h"
#include "app/program/EndSignals.h"
#include "app/reports/ExtremesReport.h"
#include "app/reports/TradeOffReport.h"
#include "app/runs/OutputFolder.h"
#include "core/Error.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"
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
    const CancelOnSignal cancel;    // between one piece of work and the next, too
    const OffscreenApplication qt;  // the maps need its fonts
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
        writeExtremesMap(folder / "extremes.png", findings.regions);
        writeCouplingMap(folder / "coupling.png", findings.holds);
    });
    out.commit();
    printExtremes(findings, spent.count());
    reportDefects(findings);
}

struct TradeOffOptions {
    std::string scene;
    GivenScale scale;
    std::optional<PixelRectangle> crop;
    std::string out;
    bool force = false;
};

void tradeOff(const TradeOffOptions& options) {
    const OffscreenApplication qt;  // the figure needs its fonts
    const std::filesystem::path scene =
        options.scene.empty() ? defaultSceneFile() : std::filesystem::path(options.scene);
    LoadedScene loaded = loadSceneOnTerminal(scene, {.scale = options.scale, .crop = options.crop});
    OutputFolder out(options.out, tradeOffFiles(), options.force);
    ProgressLine line("measuring");
    ProgressPart running(&line, 0.0, 0.7);
    const TradeOff study = studyTradeOff(loaded.scene, {}, &running);
    ProgressPart deforming(&line, 0.7, 1.0);
    const std::vector<DeformationResult> deformations =
        studyDeformation(loaded.scene, {}, &deforming);
    out.collect([&](const std::filesystem::path& folder) {
        writeTradeOff(folder, study);
        writeNeeds(folder / "needs.csv", loaded.needs);
        writeDeformations(folder / "deformation.csv", deformations);
    });
    out.commit();
    printTradeOff(study, loaded.needs.tolerance);
    printNeeds(loaded.needs);
    printDeformations(deformations);
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

void addTradeOffCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("tradeoff", "Measure cost and error of every model option");
    const auto options = std::make_shared<TradeOffOptions>();
    addScaleOptions(*command, options->scale);
    addCropOption(*command, options->crop);
    command->add_option("SCENE", options->scene,
                        "scene.toml or height map (default: the default scene)");
    addOutputFolder(*command, options->out, "folder for the table and the figure");
    addForce(*command, options->force);
    command->callback([options] { tradeOff(*options); });
}

}  // namespace asperity
