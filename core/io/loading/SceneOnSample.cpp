#include "core/io/loading/SceneOnSample.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/materials/MaterialMapFiles.h"
#include "core/probe/recorded/PlayedCurve.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace asperity {

namespace {

using Heights = std::variant<HeightMap, ScanMap>;

/// The curve that the instrument plays; null: it is simulated. Its path becomes absolute.
std::shared_ptr<const PlayedCurve> readCurve(TruthDescription& truth,
                                             std::vector<std::string>* notes) {
    if (truth.curve.empty()) {
        return nullptr;
    }
    const std::filesystem::path file = std::filesystem::absolute(truth.curve).lexically_normal();
    truth.curve = file.string();
    try {
        auto curve = playedCurve(readForceCurve(file), truth.curveStiffness);
        if (notes != nullptr) {
            notes->push_back("the instrument plays the curve " + file.filename().string() +
                             ", measured with a lever of " + formatSi(curve->stiffness, "N/m") +
                             ": its forces and its noise, whatever else [truth] says");
        }
        return curve;
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(truth.curve, "", error.what());
    }
}

/// All files beside the sample's. @param notes get what is to be said of them; may be null
SceneMaps readBeside(SceneDescription& description, const MapArea& area, Progress* progress,
                     std::vector<std::string>* notes) {
    SceneMaps read = readSceneMaps(description, area, progress, notes);
    read.curve = readCurve(description.truth, notes);
    return read;
}

/// @param notes get those on the files beside the sample's; may be null
Scene built(SceneDescription description, const MapArea& area, Heights heights, Progress* progress,
            std::vector<std::string>* notes) {
    ProgressPart mapping(progress, 0.0, 0.1);
    ProgressPart building(progress, 0.1, 1.0);
    const SceneMaps maps = readBeside(description, area, &mapping, notes);
    return std::visit(
        [&](auto map) { return buildScene(description, std::move(map), &building, maps); },
        std::move(heights));
}

SceneOnSample onShape(SceneDescription description) {
    std::vector<std::string> notes;
    const MapArea area = shapeArea(description.sample.shape->size);
    const SceneMaps maps = readBeside(description, area, nullptr, &notes);
    return {.scene = buildScene(description, maps),
            .file = nullptr,
            .format = "shape",
            .notes = std::move(notes),
            .provenance = {}};
}

/// All of a channel is no part of it.
std::optional<PixelRectangle> properPart(const std::optional<PixelRectangle>& crop,
                                         const ScanChannel& channel) {
    const PixelRectangle all{0, 0, channel.map.columns, channel.map.rows};
    return crop == all ? std::nullopt : crop;
}

std::size_t holesIn(const Heights& heights) {
    return std::visit(
        [](const auto& map) {
            return static_cast<std::size_t>(std::ranges::count(map.invalid, true));
        },
        heights);
}

}  // namespace

SceneOnSample sceneOnSample(SceneDescription description, Progress* progress) {
    SampleDescription& sample = description.sample;
    if (sample.shape) {
        return onShape(std::move(description));
    }
    ProgressPart reading(progress, 0.0, 0.3);
    ProgressPart building(progress, 0.3, 1.0);
    sample.file = std::filesystem::absolute(sample.file).lexically_normal().string();
    auto file = std::make_unique<const ScanFile>(sample.file, sample.scale);
    const ScanChannel& channel = heightChannel(file->contents(), sample.file, sample.channel);
    sample.crop = properPart(sample.crop, channel);
    SceneScan scan = file->readSceneScan(sample.channel, sample.crop, &reading);
    sample.channel = scan.channel;
    const MapArea area = mapArea(channel.map, sample.crop);
    const std::size_t holes = holesIn(scan.map);
    Scene scene = built(std::move(description), area, std::move(scan.map), &building, &scan.notes);
    return {.scene = std::move(scene),
            .file = std::move(file),
            .format = std::move(scan.format),
            .notes = std::move(scan.notes),
            .provenance = std::move(scan.provenance),
            .filledPixels = holes,
            .originX = scan.originX,
            .originY = scan.originY};
}

Scene sceneOnHeights(SceneDescription description, std::variant<HeightMap, ScanMap> heights,
                     Progress* progress) {
    if (description.sample.shape) {
        throw Error("the scene's sample is a shape; expected a scene of a height map");
    }
    description.sample.crop.reset();
    const MapArea area = std::visit([](const auto& map) { return mapArea(map); }, heights);
    return built(std::move(description), area, std::move(heights), progress, nullptr);
}

}  // namespace asperity
