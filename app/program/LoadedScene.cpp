#include "app/program/LoadedScene.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/fidelity/ForceErrorText.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ImagingTip.h"
#include "core/scene/SceneTruth.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace asperity {

namespace {

std::string levelingNote(const Scene& scene) {
    switch (scene.description.sample.leveling) {
    case Leveling::None:
        return "leveling: none, heights as the file gives them";
    case Leveling::Rows:
        return "leveling: the median of each row and the mean removed";
    case Leveling::Plane:
        break;
    }
    return formatted("leveling: plane with slopes %+.4g along x and %+.4g along y removed "
                     "(--level none keeps it)",
                     scene.removedPlane.slopeX, scene.removedPlane.slopeY);
}

std::string lawNote(const Scene& scene) {
    std::string note = std::string("contact law: ") + keyOf(scene.model.law) + " (" +
                       usualLaw(scene.description).why + ")";
    if (const MaugisTable* table = scene.belief.contact.table()) {
        note += formatted("; tabulated, error at most %.2g of the force or pi w R",
                          table->errorBound());
    }
    return note;
}

/// What the model leaves out, but for what its law has no room for: that is told with the law.
std::string modelNote(const SceneNeeds& needs) {
    std::string out;
    for (const TermNeed& need : needs.terms) {
        const auto& misses = needs.lawMisses;
        if (!need.on && std::ranges::find(misses, need.term) == misses.end()) {
            out += (out.empty() ? "" : ", ") + std::string(nameOf(need.term));
        }
    }
    const std::string tolerance = formatted(" (tolerance %.2g %%)", 100.0 * needs.tolerance);
    return "model: " + forceErrorText(needs) + tolerance +
           (out.empty() ? ", nothing left out" : "; left out: " + out);
}

LoadedScene shapeScene(const SceneDescription& description, const SceneOverrides& overrides) {
    if (!overrides.channel.empty() || overrides.leveling || overrides.smoothingPixels) {
        throw Error(
            "a scene with a shape has no height map whose channel, leveling or smoothing to "
            "choose");
    }
    return {.scene = buildScene(description),
            .format = "shape",
            .sha256 = "",
            .notes = {"the sample is an exact shape, drawn by 256 x 256 heights"},
            .needs = {}};
}

LoadedScene mapScene(SceneDescription description, const SceneOverrides& overrides,
                     Progress* progress) {
    SampleDescription& sample = description.sample;
    if (!overrides.channel.empty()) {
        sample.channel = overrides.channel;
    }
    if (overrides.leveling) {
        sample.leveling = *overrides.leveling;
    }
    if (overrides.smoothingPixels) {
        sample.smoothingPixels = *overrides.smoothingPixels;
        sample.smoothingLength = 0.0;
    }
    sample.file = std::filesystem::absolute(sample.file).lexically_normal().string();
    ProgressPart reading(progress, 0.0, 0.2);
    const ScanFile file(sample.file);
    SceneScan scan = file.readSceneScan(sample.channel, &reading);
    sample.channel = scan.channel;
    ProgressPart hashing(progress, 0.2, 0.4);
    std::string hash = file.sha256(&hashing);
    ProgressPart building(progress, 0.4, 1.0);
    const auto build = [&](auto map) { return buildScene(description, std::move(map), &building); };
    LoadedScene loaded{.scene = std::visit(build, std::move(scan.map)),
                       .format = std::move(scan.format),
                       .sha256 = std::move(hash),
                       .notes = std::move(scan.notes),
                       .needs = {}};
    loaded.notes.push_back(levelingNote(loaded.scene));
    loaded.notes.push_back(imagingTipNote(loaded.scene));
    return loaded;
}

}  // namespace

LoadedScene loadScene(const std::filesystem::path& input, const SceneOverrides& overrides,
                      Progress* progress) {
    const SceneDescription description = sceneFromInput(input);
    try {
        LoadedScene loaded = description.sample.shape ? shapeScene(description, overrides)
                                                      : mapScene(description, overrides, progress);
        loaded.needs = fitModel(loaded.scene);
        loaded.notes.push_back(lawNote(loaded.scene));
        loaded.notes.push_back(modelNote(loaded.needs));
        return loaded;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(input.string(), "", error.what());
    }
}

LoadedScene withMaterial(LoadedScene loaded, const SampleMaterial& material) {
    loaded.scene = withMaterial(std::move(loaded.scene), material);
    loaded.needs = fitModel(loaded.scene);
    return loaded;
}

LoadedScene withChoices(LoadedScene loaded, const SceneDescription& choices) {
    loaded.scene.description = choices;
    loaded.needs = fitModel(loaded.scene);
    return loaded;
}

std::unique_ptr<AfmController> instrumentOf(const Scene& scene) {
    return std::make_unique<SimulatedAfm>(scene.touched(), truthOf(scene));
}

}  // namespace asperity
