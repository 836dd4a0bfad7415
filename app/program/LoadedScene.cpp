#include "app/program/LoadedScene.h"

#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneTruth.h"
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
        overrides.smoothingPixels || overrides.scale.hasSize() || overrides.scale.hasHeight()) {
        throw Error(
            "a scene with a shape has no height map whose channel, scale, leveling or smoothing to "
            "choose");
    }
    return {.scene = buildScene(description),
            .format = "shape",
            .sha256 = "",
            .notes = {},
            .provenance = {},
            .needs = {}};
}

LoadedScene mapScene(SceneDescription description, const SceneOverrides& overrides,
                     Progress* progress) {
    SampleDescription& sample = description.sample;
    if (!overrides.channel.empty()) {
        sample.channel = overrides.channel;
    }
    sample.scale = merged(sample.scale, overrides.scale);
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
    sample.file = std::filesystem::absolute(sample.file).lexically_normal().string();
    ProgressPart reading(progress, 0.0, 0.2);
    const ScanFile file(sample.file, sample.scale);
    SceneScan scan = file.readSceneScan(sample.channel, &reading);
    sample.channel = scan.channel;
    ProgressPart hashing(progress, 0.2, 0.4);
    std::string hash = file.sha256(&hashing);
    ProgressPart building(progress, 0.4, 1.0);
    const auto build = [&](auto map) { return buildScene(description, std::move(map), &building); };
    return {.scene = std::visit(build, std::move(scan.map)),
            .format = std::move(scan.format),
            .sha256 = std::move(hash),
            .notes = std::move(scan.notes),
            .provenance = std::move(scan.provenance),
            .needs = {},
            .channels = heightChannels(file.contents())};
}

}  // namespace

LoadedScene loadScene(const std::filesystem::path& input, const SceneOverrides& overrides,
                      Progress* progress) {
    SceneDescription description = sceneFromInput(input);
    description.setpoint = overrides.setpoint.value_or(description.setpoint);
    try {
        LoadedScene loaded = description.sample.shape ? shapeScene(description, overrides)
                                                      : mapScene(description, overrides, progress);
        loaded.needs = fitModel(loaded.scene);
        std::ranges::move(surfaceNotes(loaded.scene), std::back_inserter(loaded.notes));
        return loaded;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(input.string(), "", error.what());
    }
}

std::vector<std::string> notesOn(const LoadedScene& loaded) {
    std::vector<std::string> notes = loaded.notes;
    std::ranges::move(forceNotes(loaded.scene, loaded.needs), std::back_inserter(notes));
    return notes;
}

LoadedScene withMaterial(LoadedScene loaded, const SampleMaterial& material) {
    loaded.scene = withMaterial(std::move(loaded.scene), material);
    loaded.needs = fitModel(loaded.scene);
    return loaded;
}

LoadedScene withDescription(LoadedScene loaded, const SceneDescription& description) {
    loaded.scene = withDescription(std::move(loaded.scene), description);
    loaded.needs = fitModel(loaded.scene);
    return loaded;
}

LoadedScene withChoices(LoadedScene loaded, const SceneDescription& choices) {
    loaded.scene.description = choices;
    loaded.needs = fitModel(loaded.scene);
    return loaded;
}

std::unique_ptr<AfmController> instrumentOf(const Scene& scene) {
    return std::make_unique<SimulatedAfm>(scene.trueSurface(), truthOf(scene));
}

}  // namespace asperity
