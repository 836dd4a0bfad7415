#include "app/loading/SceneLoader.h"

#include "app/loading/SurfaceImages.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/fidelity/SceneNeeds.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/materials/MaterialMapFiles.h"
#include "core/io/scene/SceneFile.h"
#include "core/surface/MergedScale.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace asperity {

namespace {

LoadedScene shapeScene(const SceneDescription& description, const SceneOverrides& overrides) {
    if (!overrides.channel.empty() || overrides.leveling || overrides.levelPoints ||
        overrides.smoothingPixels || overrides.scale.hasSize() || overrides.scale.hasHeight() ||
        overrides.crop) {
        throw Error(
            "a scene with a shape has no height map whose channel, scale, crop, leveling or "
            "smoothing to choose");
    }
    SceneDescription read = description;
    const SceneMaps maps = readSceneMaps(read, shapeArea(description.sample.shape->size));
    return {.scene = buildScene(read, maps),
            .format = "shape",
            .sha256 = "",
            .notes = {},
            .provenance = {},
            .needs = {}};
}

/// All of a channel is no part of it.
std::optional<PixelRectangle> properPart(const std::optional<PixelRectangle>& crop,
                                         const ScanChannel& channel) {
    const PixelRectangle all{0, 0, channel.map.columns, channel.map.rows};
    return crop == all ? std::nullopt : crop;
}

LoadedScene mapScene(SceneDescription description, const SceneOverrides& overrides,
                     Progress* progress) {
    SampleDescription& sample = description.sample;
    sample = withOverrides(std::move(sample), overrides);
    sample.file = std::filesystem::absolute(sample.file).lexically_normal().string();
    ProgressPart reading(progress, 0.0, 0.2);
    const ScanFile file(sample.file, sample.scale);
    const ScanChannel& heights = heightChannel(file.contents(), sample.file, sample.channel);
    sample.crop = properPart(sample.crop, heights);
    SceneScan scan = file.readSceneScan(sample.channel, sample.crop, &reading);
    sample.channel = scan.channel;
    ProgressPart hashing(progress, 0.2, 0.3);
    std::string hash = file.sha256(&hashing);
    ProgressPart mapping(progress, 0.3, 0.4);
    const SceneMaps maps =
        readSceneMaps(description, mapArea(heights.map, sample.crop), &mapping, &scan.notes);
    ProgressPart building(progress, 0.4, 1.0);
    const std::size_t holes = std::visit(
        [](const auto& map) {
            return static_cast<std::size_t>(std::ranges::count(map.invalid, true));
        },
        scan.map);
    const auto build = [&](auto map) {
        return buildScene(description, std::move(map), &building, maps);
    };
    return {.scene = std::visit(build, std::move(scan.map)),
            .format = std::move(scan.format),
            .sha256 = std::move(hash),
            .notes = std::move(scan.notes),
            .provenance = std::move(scan.provenance),
            .needs = {},
            .images = imagesBeside(file.contents(), scan.channel),
            .channels = heightChannels(file.contents()),
            .filledPixels = holes,
            .originX = scan.originX,
            .originY = scan.originY};
}

/// @param name that an error says
LoadedScene loadNamed(const std::string& name, const SceneDescription& description,
                      const SceneOverrides& overrides, Progress* progress, ModelFit fit) {
    try {
        ProgressPart loading(progress, 0.0, fit == ModelFit::Now ? 0.8 : 1.0);
        LoadedScene loaded = description.sample.shape ? shapeScene(description, overrides)
                                                      : mapScene(description, overrides, &loading);
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
        isSceneOfRun(input) ? readRecordedScene(input) : sceneFromInput(input);
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

}  // namespace asperity
