#include "app/commands/ConvertMap.h"
#include "app/commands/ProgressLine.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/ScanImage.h"

#include <utility>

namespace asperity {

namespace {

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
