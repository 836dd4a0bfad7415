#include "vtkplugins/paraview/module/SceneInput.h"

#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/materials/MaterialMapFiles.h"
#include "core/io/scene/SceneFile.h"

#include <utility>

namespace asperity {

namespace {

Scene built(SceneDescription description, std::variant<HeightMap, ScanMap> heights,
            const MapArea& area, Progress* progress) {
    const SceneMaps maps = readSceneMaps(description, area);
    return std::visit(
        [&](auto map) { return buildScene(description, std::move(map), progress, maps); },
        std::move(heights));
}

}  // namespace

Scene sceneOf(const std::string& file, std::variant<HeightMap, ScanMap> heights,
              Progress* progress) {
    SceneDescription description = file.empty() ? defaultScene() : readScene(file);
    if (description.sample.shape) {
        throw Error(file + ": its sample is a shape; expected a scene of a height map");
    }
    description.sample.crop.reset();
    const MapArea area = std::visit([](const auto& map) { return mapArea(map); }, heights);
    return built(std::move(description), std::move(heights), area, progress);
}

Scene sceneOf(const std::string& file, Progress* progress) {
    SceneDescription description = sceneFromInput(file);
    SampleDescription& sample = description.sample;
    if (sample.shape) {
        const double size = sample.shape->size;
        const SceneMaps maps = readSceneMaps(description, shapeArea(size));
        return buildScene(description, maps);
    }
    ProgressPart reading(progress, 0.0, 0.4);
    ProgressPart building(progress, 0.4, 1.0);
    const ScanFile scanFile(sample.file, sample.scale);
    SceneScan scan = scanFile.readSceneScan(sample.channel, sample.crop, &reading);
    sample.channel = scan.channel;
    const ScanChannel& heights = heightChannel(scanFile.contents(), sample.file, sample.channel);
    const MapArea area = mapArea(heights.map, sample.crop);
    return built(std::move(description), std::move(scan.map), area, &building);
}

}  // namespace asperity
