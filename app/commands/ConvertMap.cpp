#include "app/commands/ConvertMap.h"

#include "app/commands/ProgressLine.h"
#include "app/exports/SurfaceFile.h"
#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/GaussianFilter.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/leveling/Leveling.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <utility>

namespace asperity {

namespace {

HeightMapMeta metaOf(const ScanChannel& channel) {
    return {.title = channel.name,
            .originX = channel.originX,
            .originY = channel.originY,
            .metadata = channel.metadata};
}

std::string summaryOf(const std::string& channel, const HeightRows& map, const PixelMask& invalid) {
    std::string text = "'" + channel + "', " + std::to_string(map.columns) + " x " +
                       std::to_string(map.rows) + " pixels";
    if (const auto lost = std::ranges::count(invalid, true); lost > 0) {
        text += ", " + std::to_string(lost) + " of them without data";
    }
    return text;
}

/// Counts of 16 bits have none for "no data" that other programs know.
void noteHoles(const ConvertOptions& options, const ConvertedFile& files, const PixelMask& invalid,
               std::vector<std::string>& notes) {
    const bool isCounts =
        options.bits == 16 ||
        lowerCase(std::filesystem::path(files.output).extension().string()) == ".png";
    if (isCounts && std::ranges::count(invalid, true) > 0) {
        notes.emplace_back("pixels without data are count 0 in the file written: Asperity reads "
                           "them as such, other programs show pits");
    }
}

/// Returns whether a file will hold the heights in single precision.
bool isSinglePrecision(const ConvertOptions& options, const std::string& file) {
    const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
    const bool isTiff = extension == ".tif" || extension == ".tiff";
    return extension == ".gsf" || extension == ".exr" || (isTiff && options.bits != 16);
}

/// A relief of nanometers on an offset of millimeters is lost in single precision.
void noteSteps(const ConvertOptions& options, const ConvertedFile& files, const HeightMap& map,
               std::vector<std::string>& notes) {
    constexpr double kFewSteps = 1000.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double height : map.heights) {
        if (isFiniteHeight(height)) {
            low = std::min(low, height);
            high = std::max(high, height);
        }
    }
    const double largest = std::max(std::abs(low), std::abs(high));
    const double step = largest * std::numeric_limits<float>::epsilon();
    if (isSinglePrecision(options, files.output) && high > low && (high - low) < kFewSteps * step) {
        notes.push_back("the relief of " + formatSi(high - low, "m") +
                        " is written in steps of about " + formatSi(step, "m") +
                        ", because the heights lie at " + formatSi(largest, "m") +
                        "; --level plane removes that, .gwy and .txt keep all digits");
    }
}

/// Notes each request; that there was none is not noted.
template <class Map>
Map leveledAsAsked(const ConvertOptions& options, Map map, std::vector<std::string>& notes) {
    ProgressLine line("leveling");
    LeveledMap<Map> level =
        leveledInSteps(std::move(map), options.leveling, options.levelPoints, &line);
    if (!options.leveling.empty()) {
        std::ranges::move(levelingNotes(level.removed), std::back_inserter(notes));
    }
    return std::move(level.map);
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
    writeTarget(options, options.certainty, map, meta);
}

std::string certaintyNote(const ScanReconstruction& known) {
    const auto certain = std::ranges::count(known.certain, 1);
    return "eroded; the imaging tip certainly touched " + std::to_string(certain) + " of " +
           std::to_string(known.certain.size()) +
           " pixels, elsewhere the surface may lie below the heights written";
}

/// Returns the surface under the map, and writes the certainty map.
ScanMap withoutTip(const ConvertOptions& options, ScanMap level, const HeightMapMeta& meta,
                   std::vector<std::string>& notes) {
    ScanReconstruction known = [&] {
        ProgressLine line("eroding");
        return reconstructed(std::move(level), options.tipRadius, &line);
    }();
    notes.push_back(certaintyNote(known));
    if (!options.certainty.empty()) {
        writeCertainty(options, known, meta);
    }
    return std::move(known.surface);
}

/// Heights that are computed again, in single precision.
Converted convertFiltered(const ConvertOptions& options, const ConvertedFile& files) {
    HeightMapMeta meta;
    HeightScan scan = [&] {
        ProgressLine line("loading");
        const ScanFile file(files.input, options.scale);
        meta = metaOf(heightChannel(file.contents(), files.input, options.channel));
        return file.readHeightScan(options.channel, &line);
    }();
    requireHeights(scan.map, files.input);
    scan.map = leveledAsAsked(options, std::move(scan.map), scan.notes);
    scan.map = options.residual ? residual(options, std::move(scan.map))
                                : withoutTip(options, std::move(scan.map), meta, scan.notes);
    const HeightRows rows = rowsOf(scan.map);
    writeTarget(options, files.output, rows, meta);
    noteHoles(options, files, scan.map.invalid, scan.notes);
    return {summaryOf(scan.channel, rows, scan.map.invalid), std::move(scan.notes)};
}

/// Returns whether a file's format holds a surface, which needs heights, and not an image.
bool isShape(const std::string& file) {
    const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
    return std::ranges::any_of(surfaceFormats(), [&](const HeightMapFormat* format) {
        return format->isShape && std::ranges::count(format->extensions, extension) > 0;
    });
}

/// Heights as the file gives them, but for leveling.
Converted convertPlainly(const ConvertOptions& options, const ConvertedFile& files) {
    HeightChannel file = [&] {
        ProgressLine line("loading");
        return ScanFile(files.input, options.scale).readHeightChannel(options.channel, &line);
    }();
    ScanChannel& channel = file.channel;
    if (!options.leveling.empty() || isShape(files.output)) {
        requireHeights(channel.map, files.input);
    }
    const HeightMap map = leveledAsAsked(options, std::move(channel.map), file.notes);
    const HeightRows rows = rowsOf(map);
    writeTarget(options, files.output, rows, metaOf(channel));
    noteHoles(options, files, map.invalid, file.notes);
    noteSteps(options, files, map, file.notes);
    return {summaryOf(channel.name, rows, map.invalid), std::move(file.notes)};
}

/// The name, and the direction where the name does not say it: channels of both differ by it.
std::string titleOf(const ScanChannel& channel) {
    const bool isSaid =
        channel.direction.empty() || directionFromName(channel.name) == channel.direction;
    return isSaid ? channel.name : channel.name + " (" + channel.direction + ")";
}

/// Values in a unit without prefix: the format has none.
HeightRows inBaseUnit(HeightRows rows, double factor) {
    if (factor == 1.0) {
        return rows;
    }
    rows.readRow = [read = std::move(rows.readRow), factor,
                    columns = rows.columns](int row, double* values) {
        read(row, values);
        for (int column = 0; column < columns; ++column) {
            values[column] *= factor;
        }
    };
    return rows;
}

WrittenImage imageOf(const ScanFile& file, const ScanChannel& channel) {
    const PhysicalUnit unit = parseUnit(channel.unit);
    return {.rows = inBaseUnit(file.rowsOf(channel), unit.factor),
            .meta = {.title = titleOf(channel),
                     .originX = channel.originX,
                     .originY = channel.originY,
                     .unit = unit.base,
                     .metadata = channel.metadata},
            .lateralUnit = channel.lateralUnit};
}

std::string summaryOf(const HeightMapFile& file) {
    std::string text = std::to_string(file.channels.size()) +
                       (file.channels.size() == 1 ? " channel:" : " channels:");
    for (const ScanChannel& channel : file.channels) {
        text += (&channel == file.channels.data() ? " '" : ", '") + titleOf(channel) + "'";
    }
    return text;
}

}  // namespace

Converted convertMap(const ConvertOptions& options, const ConvertedFile& file) {
    return options.residual || options.tipRadius > 0.0 ? convertFiltered(options, file)
                                                       : convertPlainly(options, file);
}

Converted convertAll(const ConvertOptions& options, const ConvertedFile& files) {
    const ScanFile file(files.input, options.scale);
    std::vector<WrittenImage> images;
    Converted converted{.summary = summaryOf(file.contents()), .notes = file.contents().notes};
    for (const ScanChannel& channel : file.contents().channels) {
        images.push_back(imageOf(file, channel));
        const std::vector<std::string> notes = ownNotes(channel);
        converted.notes.insert(converted.notes.end(), notes.begin(), notes.end());
    }
    ProgressLine line("writing");
    writeHeightMaps(files.output, images, &line);
    return converted;
}

}  // namespace asperity
