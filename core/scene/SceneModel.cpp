#include "core/scene/SceneModel.h"

#include "core/scene/ModelTerm.h"

#include <optional>
#include <utility>

namespace asperity {

namespace {

/// The law with or without what the scene says of its terms.
SceneModel withLawOf(SceneModel model, const TermChoices& terms) {
    for (const ModelTerm term : {ModelTerm::FilmBase, ModelTerm::SphereCorrection,
                                 ModelTerm::VanDerWaalsTail, ModelTerm::Adhesion}) {
        const std::optional<bool> choice = terms.*choiceMember(term);
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
    SceneModel model{.law = chooseLaw(scene.law, contactPair(scene, scene.sample.material),
                                      scene.sample.material.filmThickness),
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
