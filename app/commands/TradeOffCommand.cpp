#include "app/commands/TradeOffCommand.h"

#include "app/commands/CropOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/program/DataFolder.h"
#include "app/reports/TradeOffFiles.h"
#include "app/reports/TradeOffReport.h"
#include "app/runs/OutputFolder.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace asperity {

namespace {

struct TradeOffOptions {
    std::string scene;
    GivenScale scale;
    std::optional<PixelRectangle> crop;
    std::string out;
    bool force = false;
};

void tradeOff(const TradeOffOptions& options) {
    const VirtualDisplay display;  // before anything is written: the figure needs it at the end
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
