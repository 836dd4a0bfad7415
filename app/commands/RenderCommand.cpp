#include "app/commands/RenderCommand.h"

#include "app/commands/OffscreenApplication.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/PictureOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/exports/OutputName.h"
#include "app/exports/PictureExport.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

namespace asperity {

namespace {

struct RenderOptions {
    std::string input;
    std::string out;
    std::string at;
    bool force = false;
    PictureOptions picture;
};

PictureRequest requestOf(const RenderOptions& options) {
    const bool hasRun = holdsRun(options.input);
    if (!options.at.empty() && !hasRun) {
        throw CLI::ValidationError("--at", options.input +
                                               " is no run; give the folder of one, or a bundle");
    }
    PictureRequest request{
        .view = viewOf(options.picture),
        .moment = runMoment(options.at.empty() ? keyOf(NamedMoment::Deepest) : options.at),
        .spec = specOf(options.picture)};
    requireDrawable(request, hasRun);
    return request;
}

ExportInput readInput(const std::filesystem::path& path) {
    ProgressLine line("loading");
    return ExportInput(path, &line);
}

void render(const RenderOptions& options) {
    const CancelOnSignal cancel;
    const PictureRequest request = requestOf(options);
    // The name of the input is known before it is read: what is wrong with --out comes first.
    const OutputNameParts parts{exportName(options.input), keyOf(request.view)};
    const std::filesystem::path path = outputPath(options.out, parts, options.force);
    const ExportFormat format = formatOf(path, request.view);
    requireWritable(path);
    std::optional<VirtualDisplay> display;
    std::optional<OffscreenApplication> application;
    if (isPlot(request.view)) {
        application.emplace();
    } else if (isRaster(format)) {
        display.emplace();
    }
    ExportInput input = readInput(options.input);
    if (!input.note().empty()) {
        std::cerr << "note: " << input.note() << '\n';
    }
    {
        ProgressLine line("drawing");
        writeExport(input, request, path, format, &line);
    }
    std::cout << printable(path.string()) << '\n';
}

}  // namespace

void addRenderCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "render", "Draw a scene, or a moment of a run, as a picture, a plot, or a field");
    const auto options = std::make_shared<RenderOptions>();
    command
        ->add_option("INPUT", options->input,
                     "height map, scene.toml, folder that explore or a recording wrote, or a "
                     "bundle of one")
        ->required();
    command
        ->add_option("--out", options->out,
                     "file: " + extensionHelp() +
                         ". A folder, or a name with {file}, {view}, {n}: a new file of such a "
                         "name")
        ->required()
        ->check(notEmpty());
    command
        ->add_option("--at", options->at,
                     "moment of a run: seconds, or " + keyList<NamedMoment>() +
                         "; default: deepest")
        ->check(acceptedBy(runMoment));
    addPictureOptions(*command, options->picture);
    command->add_flag("--force", options->force, "replace the file");
    command->callback([options] { render(*options); });
}

}  // namespace asperity
