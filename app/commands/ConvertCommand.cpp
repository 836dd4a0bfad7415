#include "app/commands/ConvertCommand.h"

#include "app/commands/ConvertMany.h"
#include "app/commands/ConvertMap.h"
#include "app/commands/ConvertRun.h"
#include "app/commands/ConvertTargets.h"
#include "app/commands/FormatOption.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ScaleOption.h"
#include "app/program/CancelOnSignal.h"
#include "core/PrintableText.h"
#include "core/surface/fit/GaussianFilter.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace asperity {

namespace {

void convertOne(const ConvertOptions& options) {
    const ConvertedFile file{options.input, options.others.front()};
    requireWritableTargets(options, file);
    const Converted converted = options.all ? convertAll(options, file) : convertMap(options, file);
    for (const std::string& note : converted.notes) {
        std::cerr << "note: " << printable(note) << '\n';
    }
    std::cerr << printable(file.output) << ": " << printable(converted.summary) << '\n';
}

void convert(const ConvertOptions& options) {
    const CancelOnSignal cancel;  // between one piece of work and the next, too
    if (!options.folder.empty()) {
        convertMany(options);
        return;
    }
    if (options.others.size() != 1) {
        throw CLI::ValidationError("OUT", "one output file is expected; for many inputs name a "
                                          "folder with --out-dir and a format with --to");
    }
    if (options.runFormat) {
        convertRun(options.input, options.others.front(), *options.runFormat, options.force);
        return;
    }
    convertOne(options);
}

/// A run has none of what the options for maps are about.
void addRunFormat(CLI::App& command, std::optional<RunFormat>& format) {
    const std::vector<CLI::Option*> ofMaps = command.get_options([](const CLI::Option* option) {
        return !option->get_lnames().empty() && !option->check_lname("force") &&
               !option->check_lname("help");
    });
    CLI::Option* const added = addFormatOption(
        command, format, "IN is the folder of a run, OUT another one, its tables are written as");
    for (CLI::Option* const option : ofMaps) {
        added->excludes(option);
    }
}

void addFiles(CLI::App& command, ConvertOptions& options) {
    command.add_option("IN", options.input, "height-map file, or the folder of a run")->required();
    command.add_option("OUT", options.others,
                       "file to write; its extension names the format (with --out-dir: more files "
                       "to read)");
    auto* folder = command
                       .add_option("--out-dir", options.folder,
                                   "folder to write a file for each of any number of files IN")
                       ->check(notEmpty());
    auto* format = command
                       .add_option("--to", options.extension,
                                   "with --out-dir, the format by its extension: gsf")
                       ->needs(folder)
                       ->check(notEmpty());
    folder->needs(format);
    command.add_flag("--force", options.force, "replace existing files");
}

void addFormatOptions(CLI::App& command, ConvertOptions& options) {
    command.add_flag("--all", options.all,
                     "write all channels, with names, units, masks and metadata, to .gwy");
    command
        .add_option("--bits", options.bits,
                    "16: write a .tiff of 16-bit counts, whose scale stands in its description")
        ->check(CLI::IsMember({16}));
}

CLI::Option* addResidual(CLI::App& command, ConvertOptions& options) {
    CLI::Option* residual = command.add_flag(
        "--residual", options.residual,
        "write the residual of smoothing (data minus surface) in place of the map");
    CLI::Option* pixels =
        command
            .add_option(
                "--smoothing-px", options.smoothingPixels,
                "smoothing of the residual's surface: standard deviation [pixel] (default 1)")
            ->check(finiteNumber())
            ->check(CLI::Range(0.0, kMaxSmoothing))
            ->needs(residual);
    command.add_option("--smoothing-m", options.smoothingLength, "the same as a length [m]")
        ->check(finiteNumber())
        ->check(CLI::PositiveNumber)
        ->needs(residual)
        ->excludes(pixels);
    return residual;
}

CLI::Option* addErosion(CLI::App& command, ConvertOptions& options) {
    auto* erode = command
                      .add_option("--erode", options.tipRadius,
                                  "remove the shape of the spherical tip that recorded the "
                                  "heights, by gray-scale erosion, after leveling: its radius "
                                  "[m]")
                      ->check(finiteNumber())
                      ->check(CLI::Range(1e-12, 1.0));
    command
        .add_option("--certainty", options.certainty,
                    "with --erode, a second map to write: 1 where the tip certainly touched the "
                    "surface, 0 elsewhere")
        ->needs(erode)
        ->excludes(command.get_option("--out-dir"))
        ->check(notEmpty());
    return erode;
}

}  // namespace

void addConvertCommand(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Write height maps of files in another format: " + targetExtensions() +
                       "; or the tables of a run");
    addFiles(*command, *options);
    addScaleOptions(*command, options->scale);
    command->add_option("--channel", options->channel,
                        "name of the channel (default: the topography)");
    addFormatOptions(*command, *options);
    addLevelingOptions(*command, options->leveling, options->levelPoints, "default none");
    CLI::Option* residual = addResidual(*command, *options);
    CLI::Option* erode = addErosion(*command, *options);
    residual->excludes(erode);
    for (const char* other :
         {"--channel", "--bits", "--level", "--level-points", "--residual", "--erode"}) {
        command->get_option("--all")->excludes(command->get_option(other));
    }
    addRunFormat(*command, options->runFormat);
    command->callback([options] { convert(*options); });
}

}  // namespace asperity
