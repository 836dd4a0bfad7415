#include "app/commands/ConvertTargets.h"

#include "app/commands/ConvertCurve.h"
#include "app/commands/ProgressLine.h"
#include "app/exports/SurfaceFile.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/heightmap/HeightMapWriter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>

namespace asperity {

namespace {

constexpr int kCountBits = 16;
/// Formats that hold counts of 16 bits where floats are usual.
constexpr std::array<const HeightMapFormat*, 1> kCountFormats{&kTiffCountsFormat};

std::string extensionsOf(HeightMapFormats formats) {
    std::string text;
    for (const HeightMapFormat* format : formats) {
        if (format->write != nullptr) {
            text.append(text.empty() ? "" : " ").append(format->extensions.front());
        }
    }
    return text;
}

/// A scan is often the only copy of a measurement.
void refuseToOverwriteInput(const ConvertOptions& options, const ConvertedFile& file) {
    for (const std::string& output : {file.output, options.certainty}) {
        std::error_code ignored;
        if (std::filesystem::equivalent(file.input, output, ignored)) {
            throw Error(output + ": this is the input itself; give another output file");
        }
    }
    if (!options.certainty.empty() && file.output == options.certainty) {
        throw Error(file.output + ": heights and certainty need a file each");
    }
}

void requireNew(const ConvertOptions& options, const std::string& file) {
    requireWritable(file);
    std::error_code unknown;
    if (!options.force && std::filesystem::exists(file, unknown)) {
        throw Error(file + ": the file exists; name another one, or replace it with --force");
    }
}

/// A certainty of 1 is no height of a meter. @throw CLI::ValidationError
void requireNumbers(const std::string& file) {
    std::vector<const HeightMapFormat*> images;
    std::ranges::copy_if(surfaceFormats(), std::back_inserter(images),
                         [](const HeightMapFormat* format) { return !format->isShape; });
    if (!writeRefusal(file, images).empty()) {
        throw CLI::ValidationError(
            "--certainty", file +
                               ": this file type holds heights alone, and a certainty has no "
                               "unit; it goes into " +
                               extensionsOf(images));
    }
}

}  // namespace

HeightMapFormats targetFormats(const ConvertOptions& options) {
    return options.bits == kCountBits ? HeightMapFormats(kCountFormats) : surfaceFormats();
}

std::string targetExtensions() { return extensionsOf(surfaceFormats()); }

void requireTarget(const ConvertOptions& options, const std::string& option,
                   const std::string& file) {
    if (isCurveTable(file)) {
        requireCurveOptions(options);
        return;
    }
    if (const std::string refusal = writeRefusal(file, surfaceFormats()); !refusal.empty()) {
        throw CLI::ValidationError(option, refusal);
    }
    if (!writeRefusal(file, targetFormats(options)).empty()) {
        throw CLI::ValidationError("--bits", file + ": only " + extensionsOf(kCountFormats) +
                                                 " files leave a choice of bits");
    }
    if (options.all) {
        if (const std::string refusal = writeAllRefusal(file); !refusal.empty()) {
            throw CLI::ValidationError("--all", refusal);
        }
    }
}

void requireWritableTargets(const ConvertOptions& options, const ConvertedFile& file) {
    refuseToOverwriteInput(options, file);
    requireTarget(options, "OUT", file.output);
    requireNew(options, file.output);
    if (!options.certainty.empty()) {
        ConvertOptions certainty = options;
        certainty.bits = 0;
        requireTarget(certainty, "--certainty", options.certainty);
        requireNew(options, options.certainty);
        requireNumbers(options.certainty);
    }
}

void writeTarget(const ConvertOptions& options, const std::string& file, const HeightRows& map,
                 const HeightMapMeta& meta) {
    ProgressLine line("writing");
    const bool isCertainty = file == options.certainty;
    writeHeightMap(file, map, meta, &line, isCertainty ? surfaceFormats() : targetFormats(options));
}

}  // namespace asperity
