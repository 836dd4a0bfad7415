#include "core/scene/SceneModel.h"

namespace asperity {

namespace {

Cantilever believedLever(CantileverGeometry geometry, const SceneModel& model) {
    if (!model.mountTilt) {
        geometry.mountTilt = 0.0;
    }
    const Cantilever lever(geometry);
    return model.torsion ? lever : lever.rigidInTorsion();
}

}  // namespace

SceneModel usualModel(const SceneDescription& scene) {
    const SceneModel all;
    return {.law = chooseLaw(scene.law, contactPair(scene, scene.sample.material)),
            .solver = scene.solver,
            .decoupling = scene.decoupling,
            .footSearch = scene.footSearch.value_or(all.footSearch),
            .deformation = scene.deformation.value_or(all.deformation),
            .friction = scene.friction.value_or(all.friction),
            .torsion = scene.torsion.value_or(all.torsion),
            .mountTilt = scene.mountTilt.value_or(all.mountTilt),
            .curvature = scene.curvature.value_or(all.curvature)};
}

ProbeSystem believedSystem(const SceneDescription& scene, const SceneModel& model) {
    const SampleMaterial& material = scene.sample.material;
    ContactOptions options = contactOptions(scene, material);
    options.solver = model.solver;
    return {.contact = ContactModel(model.law.law, contactPair(scene, material), options),
            .cantilever = believedLever(scene.probe, model),
            .friction = model.friction ? material.friction : Friction{},
            .curvature = model.curvature};
}

}  // namespace asperity
