#include "core/scene/SceneParameter.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

void setStiffness(SceneDescription& scene, double stiffness) {
    const double believed = Cantilever(scene.probe).stiffness();
    constexpr double kRounding = 1e-9;  // between a stiffness and the thickness made from it
    if (std::abs(scene.truth.stiffness - believed) <= kRounding * believed) {
        scene.truth.stiffness = stiffness;
    }
    scene.probe.thickness = thicknessForStiffness(scene.probe, stiffness);
}

void setMaterial(SceneDescription& scene, SampleMaterial material) {
    if (!material.name.ends_with(kEditedSuffix)) {
        material.name += kEditedSuffix;
    }
    if (scene.truth.material == scene.sample.material) {
        scene.truth.material = material;
    }
    scene.sample.material = std::move(material);
}

}  // namespace

double parameterOf(const SceneDescription& scene, SceneParameter parameter) noexcept {
    switch (parameter) {
    case SceneParameter::TipRadius:
        return scene.tip.radius;
    case SceneParameter::SpringConstant:
        return Cantilever(scene.probe).stiffness();
    case SceneParameter::YoungsModulus:
        return scene.sample.material.elastic.youngsModulus;
    case SceneParameter::WorkOfAdhesion:
        return scene.sample.material.workOfAdhesion;
    case SceneParameter::Hardness:
        return scene.sample.material.hardness;
    }
    return 0.0;
}

SceneDescription withParameter(SceneDescription scene, SceneParameter parameter, double value) {
    SampleMaterial material = scene.sample.material;
    switch (parameter) {
    case SceneParameter::TipRadius:
        scene.tip.radius = value;
        return scene;
    case SceneParameter::SpringConstant:
        setStiffness(scene, value);
        return scene;
    case SceneParameter::YoungsModulus:
        material.elastic.youngsModulus = value;
        break;
    case SceneParameter::WorkOfAdhesion:
        material.workOfAdhesion = value;
        break;
    case SceneParameter::Hardness:
        material.hardness = value;
        break;
    }
    setMaterial(scene, std::move(material));
    return scene;
}

}  // namespace asperity
