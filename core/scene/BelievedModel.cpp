#include "core/scene/BelievedModel.h"

#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <array>
#include <optional>

namespace asperity {

namespace {

Cantilever believedLever(CantileverGeometry geometry, const ForceModelOptions& model) {
    if (!model.mountTilt) {
        geometry.mountTilt = 0.0;
    }
    const Cantilever lever(geometry);
    return model.torsion ? lever : lever.rigidInTorsion();
}

}  // namespace

LawChoice usualLaw(const SceneDescription& scene) {
    const ModelChoices& choices = scene.choices;
    LawChoice law = chooseLaw(choices.law, contactPair(scene, scene.sample.material),
                              scene.sample.material.filmThickness, scene.tip.coneHalfAngle);
    if (choices.law) {
        return law;
    }
    for (const ModelTerm term : {ModelTerm::FilmBase, ModelTerm::SphereCorrection,
                                 ModelTerm::VanDerWaalsTail, ModelTerm::Adhesion}) {
        const ForceModelOptions now{.law = law.law};
        const std::optional<bool> choice = choiceOf(term, choices);
        if (choice && *choice != has(now, term)) {
            law = {(*choice ? with(now, term) : without(now, term)).law, LawReason::TermsOfScene};
        }
    }
    return law;
}

ForceModelOptions usualModel(const SceneDescription& scene) {
    ForceModelOptions model = optionsOf(scene.choices);
    model.law = usualLaw(scene).law;
    return model;
}

SceneDescription settled(SceneDescription scene, const ForceModelOptions& model) {
    ModelChoices& choices = scene.choices;
    for (const ModelTerm term : kModelTerms) {
        const auto member = traitsOf(term).choice;
        if (member != nullptr && !(isOfLaw(term) && choices.law)) {
            choices.*member = has(model, term);
        }
    }
    choices.solver = model.solver;
    choices.closestPointSearch = model.closestPointSearch;
    choices.decoupling = model.decoupling;
    choices.deformation = model.deformation;
    return scene;
}

ProbeSystem believedSystem(const SceneDescription& scene, const ForceModelOptions& model) {
    const SampleMaterial& material = scene.sample.material;
    ContactOptions options = contactOptions(scene, material);
    options.solver = model.solver;
    return {.contact = ContactModel(model.law, contactPair(scene, material), options),
            .cantilever = believedLever(scene.probe, model),
            .friction = model.friction ? material.friction : Friction{},
            .curvature = model.curvature};
}

ProbeSystem trueSystem(const SceneDescription& description) {
    const TruthDescription& truth = description.truth;
    CantileverGeometry probe = description.probe;
    probe.thickness = thicknessForStiffness(probe, truth.stiffness);
    const SampleMaterial& material = truth.material;
    const ContactPair pair = contactPair(description, material);
    const LawChoice choice = chooseLaw(description.choices.law, pair, material.filmThickness,
                                       description.tip.coneHalfAngle);
    return {.contact = ContactModel(choice.law, pair, contactOptions(description, material)),
            .cantilever = Cantilever(probe),
            .friction = material.friction};
}

InstrumentTruth truthOf(const Scene& scene) {
    const TruthDescription& truth = scene.description.truth;
    return {.system = scene.truth,
            .noise = {.bending = truth.signalNoise, .torsion = truth.signalNoise},
            .seed = truth.noiseSeed,
            .temperature = truth.temperature,
            .timeStep = scene.timeStep()};
}

}  // namespace asperity
