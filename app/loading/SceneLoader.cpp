#include "app/loading/SceneLoader.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/fidelity/RequiredTerms.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/surface/GivenScale.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/leveling/Leveling.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace asperity {

namespace {

void requireNone(const SceneOverrides& overrides) {
    if (!overrides.channel.empty() || overrides.leveling || overrides.levelPoints ||
        overrides.smoothingPixels || overrides.scale.hasSize() || overrides.scale.hasHeight() ||
        overrides.crop) {
        throw Error(
            "a scene with a shape has no height map whose channel, scale, crop, leveling or "
            "smoothing to choose");
    }
}

LoadedScene loadedScene(SceneDescription description, const SceneOverrides& overrides,
                        Progress* progress) {
    if (description.sample.shape) {
        requireNone(overrides);
    }
    description.sample = withOverrides(std::move(description.sample), overrides);
    ProgressPart reading(progress, 0.0, 0.9);
    SceneOnSample read = sceneOnSample(std::move(description), &reading);
    LoadedScene loaded{.scene = std::move(read.scene),
                       .format = std::move(read.format),
                       .sha256 = "",
                       .notes = std::move(read.notes),
                       .provenance = std::move(read.provenance),
                       .needs = {},
                       .filledPixels = read.filledPixels,
                       .originX = read.originX,
                       .originY = read.originY};
    if (read.file) {
        ProgressPart hashing(progress, 0.9, 1.0);
        loaded.sha256 = read.file->sha256(&hashing);
        const HeightMapFile& contents = read.file->contents();
        loaded.images = imagesBeside(contents, loaded.scene.description.sample.channel);
        loaded.channels = heightChannels(contents);
    }
    return loaded;
}

/// @param name that an error says
LoadedScene loadNamed(const std::string& name, const SceneDescription& description,
                      const SceneOverrides& overrides, Progress* progress, ModelFit fit) {
    try {
        ProgressPart loading(progress, 0.0, fit == ModelFit::Now ? 0.8 : 1.0);
        LoadedScene loaded = loadedScene(description, overrides, &loading);
        ProgressPart fitting(progress, 0.8, 1.0);
        loaded.needs = fit == ModelFit::Now ? fitModel(loaded.scene, kLongestTick, &fitting)
                                            : needsBeforeFit(loaded.scene);
        std::ranges::move(surfaceNotes(loaded.scene), std::back_inserter(loaded.notes));
        return loaded;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(name, "", error.what());
    }
}

}  // namespace

SampleDescription withOverrides(SampleDescription sample, const SceneOverrides& overrides) {
    if (!overrides.channel.empty()) {
        sample.channel = overrides.channel;
    }
    sample.scale = merged(sample.scale, overrides.scale);
    if (overrides.crop) {
        sample.crop = overrides.crop;
    }
    if (overrides.leveling) {
        sample.leveling = *overrides.leveling;
    }
    if (overrides.levelPoints) {
        sample.levelPoints = overrides.levelPoints;
    }
    if (overrides.smoothingPixels) {
        sample.smoothingPixels = *overrides.smoothingPixels;
        sample.smoothingLength = 0.0;
    }
    return sample;
}

LoadedScene loadScene(const std::filesystem::path& input, const SceneOverrides& overrides,
                      Progress* progress, ModelFit fit) {
    SceneDescription description =
        isSceneOfRun(input) ? readRecordedScene(input) : sceneFromInput(input, overrides.like);
    description.setpoint = overrides.setpoint.value_or(description.setpoint);
    return loadNamed(input.string(), description, overrides, progress, fit);
}

LoadedScene loadScene(const SceneDescription& description, Progress* progress) {
    return loadNamed(sampleName(description.sample), description, {}, progress, ModelFit::Now);
}

LoadedScene withDescription(const LoadedScene& loaded, const SceneDescription& description,
                            Progress* progress, ModelFit fit) {
    LoadedScene changed{.scene = withDescription(loaded.scene, description),
                        .format = loaded.format,
                        .sha256 = loaded.sha256,
                        .notes = loaded.notes,
                        .provenance = loaded.provenance,
                        .needs = {},
                        .images = loaded.images,
                        .channels = loaded.channels,
                        .filledPixels = loaded.filledPixels};
    changed.needs = fit == ModelFit::Now ? fitModel(changed.scene, kLongestTick, progress)
                                         : needsBeforeFit(changed.scene);
    return changed;
}

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

std::variant<HeightMap, ScanMap> leveledScan(const SampleDescription& sample, Progress* progress) {
    ProgressPart reading(progress, 0.0, 0.5);
    SceneScan scan =
        ScanFile(sample.file, sample.scale).readSceneScan(sample.channel, sample.crop, &reading);
    ProgressPart leveling(progress, 0.5, 1.0);
    return std::visit(
        [&](auto map) -> std::variant<HeightMap, ScanMap> {
            return leveled(std::move(map), sample.leveling, sample.levelPoints, &leveling);
        },
        std::move(scan.map));
}

PixelField residualImage(const SampleDescription& sample, const BSplineSurface& surface,
                         Progress* progress) {
    ProgressPart loading(progress, 0.0, 0.8);
    return std::visit(
        [&surface](auto map) { return PixelField(residualOf(std::move(map), surface), "m"); },
        leveledScan(sample, &loading));
}

}  // namespace asperity
