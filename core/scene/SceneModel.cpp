#include "core/scene/SceneModel.h"

#include "core/scene/ModelTerm.h"

#include <utility>

namespace asperity {

namespace {

/// The law with or without what the scene says of its terms. The exact sphere has no tail.
SceneModel withLawOf(SceneModel model, const TermChoices& terms) {
    for (const auto& [term, choice] :
         {std::pair(ModelTerm::SphereCorrection, terms.sphereCorrection),
          std::pair(ModelTerm::VanDerWaalsTail, terms.vanDerWaalsTail),
          std::pair(ModelTerm::Adhesion, terms.adhesion)}) {
        if (choice && *choice != has(model, term)) {
            model = *choice ? with(std::move(model), term) : without(std::move(model), term);
            model.law.why = "as the scene says of its terms";
        }
    }
    return model;
}

Cantilever believedLever(CantileverGeometry geometry, const SceneModel& model) {
    if (!model.mountTilt) {
        geometry.mountTilt = 0.0;
    }
    const Cantilever lever(geometry);
    return model.torsion ? lever : lever.rigidInTorsion();
}

}  // namespace

SceneModel usualModel(const SceneDescription& scene) {
    const TermChoices& terms = scene.terms;
    const SceneModel all;
    SceneModel model{.law = chooseLaw(scene.law, contactPair(scene, scene.sample.material)),
                     .solver = scene.solver,
                     .decoupling = scene.decoupling,
                     .footSearch = scene.footSearch.value_or(all.footSearch),
                     .deformation = scene.deformation.value_or(all.deformation),
                     .friction = terms.friction.value_or(all.friction),
                     .torsion = terms.torsion.value_or(all.torsion),
                     .mountTilt = terms.mountTilt.value_or(all.mountTilt),
                     .curvature = terms.curvature.value_or(all.curvature)};
    return scene.law ? model : withLawOf(std::move(model), terms);
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
