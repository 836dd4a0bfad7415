#include "vtkplugins/paraview/module/SceneInput.h"

#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"

#include <utility>

namespace asperity {

namespace {

Scene built(const SceneDescription& description, std::variant<HeightMap, ScanMap> heights,
            Progress* progress) {
    return std::visit([&](auto map) { return buildScene(description, std::move(map), progress); },
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
    return built(description, std::move(heights), progress);
}

Scene sceneOf(const std::string& file, Progress* progress) {
    SceneDescription description = sceneFromInput(file);
    SampleDescription& sample = description.sample;
    if (sample.shape) {
        return buildScene(description);
    }
    ProgressPart reading(progress, 0.0, 0.4);
    ProgressPart building(progress, 0.4, 1.0);
    SceneScan scan =
        ScanFile(sample.file, sample.scale).readSceneScan(sample.channel, sample.crop, &reading);
    sample.channel = scan.channel;
    return built(description, std::move(scan.map), &building);
}

}  // namespace asperity
