#include "app/loading/SurfaceImages.h"

#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/Residual.h"
#include "core/surface/leveling/Leveling.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace asperity {

std::vector<std::string> imagesBeside(const HeightMapFile& file, const std::string& channel) {
    const auto scan = std::ranges::find(file.channels, channel, &ScanChannel::name);
    std::vector<std::string> names;
    if (scan == file.channels.end()) {
        return names;
    }
    for (const ScanChannel& image : file.channels) {
        const bool samePixels =
            image.map.columns == scan->map.columns && image.map.rows == scan->map.rows;
        const bool isNew = std::ranges::find(names, image.name) == names.end();
        if (samePixels && isNew && !image.name.empty() && image.name != channel) {
            names.push_back(image.name);
        }
    }
    return names;
}

PixelField imageBeside(const SampleDescription& sample, const BSplineSurface& surface,
                       const std::string& name, Progress* progress) {
    const ScanFile file(sample.file, sample.scale);
    const ScanChannel& channel = channelNamed(file.contents(), sample.file, name);
    const BSplineSurface::Grid& grid = surface.grid();
    const PixelRectangle part =
        sample.crop.value_or(PixelRectangle{0, 0, channel.map.columns, channel.map.rows});
    if (!part.liesIn(channel.map.columns, channel.map.rows) || part.columns != grid.columns ||
        part.rows != grid.rows) {
        throw InputError(sample.file, name, "the image has other pixels than the scan");
    }
    HeightMap values{.columns = grid.columns,
                     .rows = grid.rows,
                     .pitchX = grid.pitchX,
                     .pitchY = grid.pitchY,
                     .heights = {},
                     .invalid = {}};
    values.heights.reserve(values.index(values.rows, 0));
    file.forEachRow(channel, [&](int row, std::span<const double> line) {
        if (row >= part.row && row < part.row + part.rows) {
            const auto first = line.begin() + part.column;
            values.heights.insert(values.heights.end(), first, first + part.columns);
        }
        reportTo(progress, static_cast<double>(row) / channel.map.rows);
    });
    return {values, channel.unit};
}

PixelField residualImage(const SampleDescription& sample, const BSplineSurface& surface,
                         Progress* progress) {
    ProgressPart reading(progress, 0.0, 0.4);
    SceneScan scan =
        ScanFile(sample.file, sample.scale).readSceneScan(sample.channel, sample.crop, &reading);
    ProgressPart leveling(progress, 0.4, 0.8);
    const auto residual = [&](auto map) {
        return PixelField(
            residualOf(leveled(std::move(map), sample.leveling, sample.levelPoints, &leveling),
                       surface),
            "m");
    };
    return std::visit(residual, std::move(scan.map));
}

}  // namespace asperity
