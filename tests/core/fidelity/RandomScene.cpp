#include "tests/core/fidelity/RandomScene.h"

#include "core/Units.h"
#include "core/surface/fit/GaussianFilter.h"
#include "tests/support/TestScenes.h"

#include <cmath>

namespace asperity::test {

namespace {

double logUniform(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

HeightMap randomMap(Random& random) {
    constexpr int kPixels = 48;
    const double pitch = logUniform(random, 1.0_nm, 8.0_nm);
    HeightMap map{.columns = kPixels,
                  .rows = kPixels,
                  .pitchX = pitch,
                  .pitchY = pitch,
                  .heights = {},
                  .invalid = {}};
    const double range = logUniform(random, 0.01, 3.0) * pitch;
    map.heights.assign(map.index(kPixels, 0), 0.0);
    for (double& height : map.heights) {
        height = range * random.uniform();
    }
    return map;
}

/// Now and then a film, an exact shape instead of the map, a term that the scene settles itself.
void addRarities(SceneDescription& description, Random& random) {
    if (random.uniform() < 0.15) {
        description.sample.material.filmThickness = logUniform(random, 2.0_nm, 1.0_um);
    }
    if (random.uniform() < 0.1) {
        description.sample.shape = ShapeDescription{
            .kind = random.uniform() < 0.5 ? ShapeKind::Sphere : ShapeKind::Cylinder,
            .radius = logUniform(random, 90.0_nm, 500.0_nm)};
    }
    if (random.uniform() < 0.2) {
        description.choices.friction = random.uniform() < 0.5;
    }
    if (random.uniform() < 0.1) {
        description.choices.adhesion = false;
    }
    if (random.uniform() < 0.1) {
        description.choices.closestPointSearch = SearchEffort::Global;
    }
}

}  // namespace

Scene randomScene(Random& random) {
    SceneDescription description = plainScene();
    SampleMaterial& material = description.sample.material;
    material.elastic.youngsModulus = logUniform(random, 100.0_MPa, 200.0_GPa);
    material.workOfAdhesion = random.uniform() < 0.2 ? 0.0 : logUniform(random, 1e-3, 0.3);
    material.friction = {.coefficient = random.uniform() < 0.3 ? 0.0 : random.uniform(0.0, 0.8)};
    description.tip.radius = logUniform(random, 5.0_nm, 100.0_nm);
    description.probe.mountTilt = random.uniform() < 0.3 ? 0.0 : random.uniform(0.0, 0.3);
    description.truth.stiffness = logUniform(random, 2.0, 100.0);
    description.probe.thickness =
        thicknessForStiffness(description.probe, description.truth.stiffness);
    description.sample.smoothingPixels = random.uniform(0.0, 3.0);
    addRarities(description, random);
    description.truth.material = material;
    if (description.sample.shape) {
        return buildScene(description);
    }
    return buildScene(description, randomMap(random));
}

std::vector<ModelInputs> runsElsewhere(const Scene& scene) {
    constexpr double kDuration = 0.12;  // [s]
    const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
    std::vector<ModelInputs> runs;
    for (const Vector2& share : {Vector2(0.5, 0.45), Vector2(0.15, 0.8), Vector2(0.85, 0.6)}) {
        const Vector2 position = share.cwiseProduct(size);
        runs.push_back(recordInputs(
            scene, slidePath(scene, {.duration = kDuration, .position = position}), kDuration));
    }
    return runs;
}

}  // namespace asperity::test
