#include "app/commands/ConvertCommand.h"

#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/program/CancelOnSignal.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/Leveling.h"
#include "core/surface/Residual.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/imaging/TipErosion.h"
#include "vtkplugins/io/VtkFormats.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace asperity {

namespace {

struct ConvertOptions {
    std::string input;
    std::string output;
    std::string channel;
    GivenScale scale;
    Leveling leveling = Leveling::None;
    bool residual = false;
    double smoothingPixels = 1.0;  ///< of the residual's surface
    double smoothingLength = 0.0;  ///< above 0: in place of smoothingPixels [m]
    double tipRadius = 0.0;        ///< of the tip whose shape is taken out [m]; 0: none is
    std::string certainty;         ///< file for the certainty map; empty: none
    bool force = false;            ///< files that are there may go
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

/// All that a map is written in.
const std::vector<const HeightMapFormat*>& formats() {
    static const std::vector<const HeightMapFormat*> all = [] {
        std::vector<const HeightMapFormat*> list(kHeightMapFormats.begin(),
                                                 kHeightMapFormats.end());
        list.insert(list.end(), kVtkFormats.begin(), kVtkFormats.end());
        return list;
    }();
    return all;
}

/// Those of the formats that can be written, each by the first of its extensions.
std::string writtenFormats(HeightMapFormats formats) {
    std::string text;
    for (const HeightMapFormat* format : formats) {
        if (format->write != nullptr) {
            text.append(text.empty() ? "" : " ").append(format->extensions.front());
        }
    }
    return text;
}

/// Before long work is done for it. @param option that names the file
void requireWritableMap(const std::string& option, const std::string& file, bool force) {
    if (const std::string refusal = writeRefusal(file, formats()); !refusal.empty()) {
        throw CLI::ValidationError(option, refusal);
    }
    requireWritable(file);
    std::error_code unknown;
    if (!force && std::filesystem::exists(file, unknown)) {
        throw Error(file + ": the file exists; name another one, or replace it with --force");
    }
}

/// A certainty of 1 is no height of a meter. @throw CLI::ValidationError
void requireNumbers(const std::string& file) {
    std::vector<const HeightMapFormat*> images;
    std::ranges::copy_if(formats(), std::back_inserter(images),
                         [](const HeightMapFormat* format) { return !format->isShape; });
    if (!writeRefusal(file, images).empty()) {
        throw CLI::ValidationError(
            "--certainty", file +
                               ": this file type holds heights alone, and a certainty has no "
                               "unit; it goes into " +
                               writtenFormats(images));
    }
}

void writeMap(const std::filesystem::path& path, const HeightRows& map, const HeightMapMeta& meta) {
    ProgressLine line("writing");
    writeHeightMap(path, map, meta, &line, formats());
}

/// Of the file that was read.
void tellNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
        std::cerr << "note: " << printable(note) << '\n';
    }
}

void tellWritten(const ConvertOptions& options, const std::string& channel, const HeightRows& map,
                 const PixelMask& invalid) {
    std::cerr << printable(options.output) << ": '" << printable(channel) << "', " << map.columns
              << " x " << map.rows << " pixels";
    if (const auto lost = std::ranges::count(invalid, true); lost > 0) {
        std::cerr << ", " << lost << " of them without data";
    }
    std::cerr << '\n';
}

ScanMap residual(const ConvertOptions& options, ScanMap level) {
    const Smoothing smoothing = options.smoothingLength > 0.0
                                    ? smoothingByLength(options.smoothingLength, level)
                                    : Smoothing{options.smoothingPixels, options.smoothingPixels};
    ProgressLine line("fitting");
    const BSplineSurface surface = fitSurface(level, smoothing, &line);
    return residualOf(std::move(level), surface);
}

/// The certainty as a map of its own: 1 where certain, 0 elsewhere; pixels without data stay so.
void writeCertainty(const ConvertOptions& options, const ScanReconstruction& known,
                    HeightMapMeta meta) {
    HeightRows map = rowsOf(known.surface);
    map.readRow = [&known, heights = map.readRow](int row, double* values) {
        heights(row, values);
        const std::uint8_t* certain = known.certain.data() + known.surface.index(row, 0);
        for (int column = 0; column < known.surface.columns; ++column) {
            values[column] = isFiniteHeight(values[column]) ? certain[column] : values[column];
        }
    };
    meta.title = "Certainty (1: touched by the imaging tip)";
    meta.unit = "";
    writeMap(options.certainty, map, meta);
}

void tellCertainty(const ScanReconstruction& known) {
    const auto certain = std::ranges::count(known.certain, 1);
    std::cerr << "note: eroded; the imaging tip certainly touched " << certain << " of "
              << known.certain.size()
              << " pixels, elsewhere the surface may lie below the heights written\n";
}

/// The surface under the map; on the way, the certainty map is written.
ScanMap withoutTip(const ConvertOptions& options, ScanMap level, const HeightMapMeta& meta) {
    ScanReconstruction known = [&] {
        ProgressLine line("eroding");
        return reconstructed(std::move(level), options.tipRadius, &line);
    }();
    tellCertainty(known);
    if (!options.certainty.empty()) {
        writeCertainty(options, known, meta);
    }
    return std::move(known.surface);
}

/// Heights that are computed anew, in single precision.
void convertFiltered(const ConvertOptions& options) {
    HeightScan scan = [&] {
        ProgressLine line("loading");
        return ScanFile(options.input, options.scale).readHeightScan(options.channel, &line);
    }();
    tellNotes(scan.notes);
    const HeightMapMeta meta{scan.channel, scan.originX, scan.originY};
    scan.map = leveled(std::move(scan.map), options.leveling);
    scan.map = options.residual ? residual(options, std::move(scan.map))
                                : withoutTip(options, std::move(scan.map), meta);
    const HeightRows rows = rowsOf(scan.map);
    writeMap(options.output, rows, meta);
    tellWritten(options, scan.channel, rows, scan.map.invalid);
}

/// Heights as the file gives them, but for leveling.
void convertPlainly(const ConvertOptions& options) {
    HeightChannel file = [&] {
        ProgressLine line("loading");
        return ScanFile(options.input, options.scale).readHeightChannel(options.channel, &line);
    }();
    tellNotes(file.notes);
    ScanChannel& channel = file.channel;
    const HeightMap map = leveled(std::move(channel.map), options.leveling);
    const HeightRows rows = rowsOf(map);
    writeMap(options.output, rows, {channel.name, channel.originX, channel.originY});
    tellWritten(options, channel.name, rows, map.invalid);
}

void convert(const ConvertOptions& options) {
    const CancelOnSignal cancel;  // between one piece of work and the next, too
    refuseToOverwriteInput(options);
    requireWritableMap("OUT", options.output, options.force);
    if (!options.certainty.empty()) {
        requireWritableMap("--certainty", options.certainty, options.force);
        requireNumbers(options.certainty);
    }
    if (options.residual || options.tipRadius > 0.0) {
        convertFiltered(options);
    } else {
        convertPlainly(options);
    }
}

}  // namespace

void addConvertCommand(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command =
        program.add_subcommand("convert", "Write one height map of a file in another format: " +
                                              writtenFormats(formats()));
    command->add_option("IN", options->input, "height-map file")->required();
    command->add_option("OUT", options->output, "file to write; its extension names the format")
        ->required();
    command->add_flag("--force", options->force, "replace existing files");
    addScaleOptions(*command, options->scale);
    command->add_option("--channel", options->channel,
                        "name of the channel (default: the topography)");
    addLevelingOption(*command, options->leveling, "default none");
    CLI::Option* residual = command->add_flag(
        "--residual", options->residual,
        "write the residual of smoothing (data minus surface) in place of the map");
    CLI::Option* pixels =
        command
            ->add_option(
                "--smoothing-px", options->smoothingPixels,
                "smoothing of the residual's surface: standard deviation [pixel] (default 1)")
            ->check(finiteNumber())
            ->check(CLI::Range(0.0, kMaxSmoothing))
            ->needs(residual);
    command->add_option("--smoothing-m", options->smoothingLength, "the same as a length [m]")
        ->check(finiteNumber())
        ->check(CLI::PositiveNumber)
        ->needs(residual)
        ->excludes(pixels);
    auto* erode = command
                      ->add_option("--erode", options->tipRadius,
                                   "remove the shape of the spherical tip that recorded the "
                                   "heights, by gray-scale erosion, after leveling: its radius "
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
