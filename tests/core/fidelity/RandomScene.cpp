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
    description.truth.material = material;
    description.sample.smoothingPixels = random.uniform(0.0, 3.0);
    return buildScene(description, randomMap(random));
}

}  // namespace asperity::test
