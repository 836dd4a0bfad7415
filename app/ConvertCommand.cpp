#include "app/ConvertCommand.h"

#include "app/LevellingOption.h"
#include "core/Error.h"
#include "core/io/HeightMapFile.h"
#include "core/io/HeightMapWriter.h"
#include "core/io/ScanImage.h"
#include "core/surface/BSplineFit.h"
#include "core/surface/GaussianFilter.h"
#include "core/surface/Levelling.h"
#include "core/surface/Residual.h"
#include "vtkplugins/io/HeightMapWriter.h"

#include <CLI/CLI.hpp>
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
};

/// A scan is often the only copy of a measurement.
void refuseToOverwriteInput(const ConvertOptions& options) {
    std::error_code ignored;
    if (std::filesystem::equivalent(options.input, options.output, ignored)) {
        throw Error(options.output + ": this is the input itself; give another output file");
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

HeightMap result(const ConvertOptions& options, const HeightMap& map) {
    HeightMap level = levelled(map, options.levelling);
    if (!options.residual) {
        return level;
    }
    const Smoothing smoothing = options.smoothingLength > 0.0
                                    ? smoothingByLength(options.smoothingLength, level)
                                    : Smoothing{options.smoothingPixels, options.smoothingPixels};
    const BSplineSurface surface = fitSurface(level, smoothing);
    return residualOf(std::move(level), surface);
}

void convert(const ConvertOptions& options) {
    const HeightMapFile file = readHeightMapFile(options.input);
    const ScanChannel& channel = heightChannel(file, options.input, options.channel);
    refuseToOverwriteInput(options);
    for (const std::string& note : file.notes) {
        std::cerr << "note: " << note << '\n';
    }
    const HeightMapMeta meta{channel.name, channel.originX, channel.originY};
    writeInAnyFormat(options.output, result(options, channel.map), meta);
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
    command->callback([options] { convert(*options); });
}

}  // namespace asperity
