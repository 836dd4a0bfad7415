#include "app/ConvertCommand.h"

#include "app/LevellingOption.h"
#include "app/OptionChecks.h"
#include "app/ProgressLine.h"
#include "core/Error.h"
#include "core/io/HeightMapFile.h"
#include "core/io/HeightMapWriter.h"
#include "core/io/ScanImage.h"
#include "core/surface/Levelling.h"
#include "core/surface/Residual.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/imaging/TipErosion.h"
#include "vtkplugins/io/HeightMapWriter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

namespace asperity {

namespace {

struct ConvertOptions {
    std::string input;
    std::string output;
    std::string channel;
    Levelling levelling = Levelling::None;
    bool residual = false;
    double smoothingPixels = 1.0;  ///< of the residual's surface
    double smoothingLength = 0.0;  ///< above 0: in place of smoothingPixels [m]
    double tipRadius = 0.0;        ///< of the tip whose shape is taken out [m]; 0: none is
    std::string certainty;         ///< file for the certainty map; empty: none
};

/// A scan is often the only copy of a measurement.
void refuseToOverwriteInput(const ConvertOptions& options) {
    for (const std::string& output : {options.output, options.certainty}) {
        std::error_code ignored;
        if (std::filesystem::equivalent(options.input, output, ignored)) {
            throw Error(output + ": this is the input itself; give another output file");
        }
    }
    if (options.output == options.certainty) {
        throw Error(options.output + ": heights and certainty need a file each");
    }
}

void writeInAnyFormat(const std::filesystem::path& path, const HeightMap& map,
                      const HeightMapMeta& meta) {
    if (canWriteHeightMap(path)) {
        writeHeightMap(path, map, meta);
        return;
    }
    if (writeHeightMapWithVtk(path, map)) {
        return;
    }
    std::string known;
    for (const std::string& extension : heightMapExtensions()) {
        known += extension + " ";
    }
    throw CLI::ValidationError("OUT", path.string() +
                                          ": no height map can be written with this extension; "
                                          "known are " +
                                          known + ".vti .vtp .stl");
}

HeightMap residual(const ConvertOptions& options, HeightMap level) {
    const Smoothing smoothing = options.smoothingLength > 0.0
                                    ? smoothingByLength(options.smoothingLength, level)
                                    : Smoothing{options.smoothingPixels, options.smoothingPixels};
    const BSplineSurface surface = fitSurface(level, smoothing);
    return residualOf(std::move(level), surface);
}

/// The certainty as a map of its own: 1 where certain, 0 elsewhere; pixels without data stay so.
void writeCertainty(const ConvertOptions& options, const TipReconstruction& known,
                    HeightMapMeta meta) {
    HeightMap map = known.surface;
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] = isFiniteHeight(map.heights[i]) ? known.certain[i] : map.heights[i];
    }
    meta.title = "Certainty (1: touched by the imaging tip)";
    writeInAnyFormat(options.certainty, map, meta);
}

void tellCertainty(const TipReconstruction& known) {
    const auto certain = std::ranges::count(known.certain, 1);
    std::cerr << "note: eroded; the imaging tip certainly touched " << certain << " of "
              << known.certain.size()
              << " pixels, elsewhere the surface may lie below the heights written\n";
}

/// What is to be written; on the way, the certainty map.
HeightMap prepared(const ConvertOptions& options, const HeightMap& map, const HeightMapMeta& meta) {
    HeightMap level = levelled(map, options.levelling);
    if (options.residual) {
        return residual(options, std::move(level));
    }
    if (options.tipRadius == 0.0) {
        return level;
    }
    ProgressLine line("eroding");
    TipReconstruction known = reconstructed(level, options.tipRadius, &line);
    tellCertainty(known);
    if (!options.certainty.empty()) {
        writeCertainty(options, known, meta);
    }
    return std::move(known.surface);
}

void convert(const ConvertOptions& options) {
    const HeightMapFile file = readHeightMapFile(options.input);
    const ScanChannel& channel = heightChannel(file, options.input, options.channel);
    refuseToOverwriteInput(options);
    for (const std::string& note : file.notes) {
        std::cerr << "note: " << note << '\n';
    }
    const HeightMapMeta meta{channel.name, channel.originX, channel.originY};
    writeInAnyFormat(options.output, prepared(options, channel.map, meta), meta);
    std::cerr << options.output << ": '" << channel.name << "', " << channel.map.columns << " x "
              << channel.map.rows << " pixels";
    if (const std::size_t lost = countInvalid(channel.map); lost > 0) {
        std::cerr << ", " << lost << " of them without data";
    }
    std::cerr << '\n';
}

}  // namespace

void addConvertCommand(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Write one height map of a file in another format: .gwy .gsf .exr .tiff .png "
                   ".txt .vti .vtp .stl");
    command->add_option("IN", options->input, "height-map file")->required();
    command->add_option("OUT", options->output, "file to write; its extension names the format")
        ->required();
    command->add_option("--channel", options->channel,
                        "name of the channel (default: the height that a lab user expects)");
    addLevellingOption(*command, options->levelling, "default none");
    CLI::Option* residual = command->add_flag(
        "--residual", options->residual,
        "write what smoothing takes from the map (data minus surface) in place of the map");
    CLI::Option* pixels =
        command
            ->add_option("--smoothing-px", options->smoothingPixels,
                         "of the residual's surface: standard deviation [pixel] (default 1)")
            ->check(CLI::Range(0.0, kWidestSmoothing))
            ->needs(residual);
    command->add_option("--smoothing-m", options->smoothingLength, "the same as a length [m]")
        ->check(CLI::PositiveNumber)
        ->needs(residual)
        ->excludes(pixels);
    auto* erode = command
                      ->add_option("--erode", options->tipRadius,
                                   "take out the shape of the spherical tip that recorded the "
                                   "heights, by grey-scale erosion, after levelling: its radius "
                                   "[m]")
                      ->check(finiteNumber())
                      ->check(CLI::Range(1e-12, 1.0));
    command
        ->add_option("--certainty", options->certainty,
                     "with --erode, a second map to write: 1 where the tip certainly touched the "
                     "surface, 0 elsewhere")
        ->needs(erode)
        ->check(notEmpty());
    residual->excludes(erode);
    command->callback([options] { convert(*options); });
}

}  // namespace asperity
