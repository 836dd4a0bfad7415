#include "core/experiment/Study.h"

namespace asperity {

SceneDescription sceneOf(const Study& study, std::size_t material, std::size_t lever) {
    SceneDescription scene = withMaterial(study.scene, study.materials.at(material));
    const bool isTrueLever = scene.truth.stiffness == Cantilever(scene.probe).stiffness();
    scene.probe = study.levers.at(lever).probe.lever;
    scene.detector = study.levers.at(lever).probe.detector;
    if (isTrueLever) {
        scene.truth.stiffness = Cantilever(scene.probe).stiffness();
    }
    scene.settings.positionGain = study.scale.positionGain;
    scene.settings.forceGain = study.scale.forceGain;
    scene.settings.forcesOn = study.aids.forces;
    checkScene(scene);
    return scene;
}

}  // namespace asperity
