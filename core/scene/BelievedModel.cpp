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

LawChoice lawFor(const SceneDescription& scene, const SampleMaterial& material) {
    const LawChoice choice = chooseLaw(scene.choices.law, contactPair(scene, material),
                                       material.filmThickness, scene.tip.coneHalfAngle);
    if (scene.choices.law || !material.hasTwoWorks()) {
        return choice;
    }
    return {isSphere(choice.law) ? ContactLaw::SphereJkr : ContactLaw::Jkr, LawReason::TwoWorks};
}

TimeTerms timeTerms(const SceneDescription& scene, const SampleMaterial& material) {
    Elastic atOnce = material.elastic;
    atOnce.youngsModulus += material.relaxingModulus;
    return {.relaxingShare = (reducedModulus(atOnce, scene.tip.elastic) /
                              reducedModulus(material.elastic, scene.tip.elastic)) -
                             1.0,
            .relaxationTime = material.relaxationTime > 0.0 ? material.relaxationTime : 1.0,
            .drag = material.drag,
            .dragOffset = material.dragOffset > 0.0 ? material.dragOffset : 1.0};
}

LawChoice usualLaw(const SceneDescription& scene) {
    const ModelChoices& choices = scene.choices;
    LawChoice law = lawFor(scene, scene.sample.material);
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
    for (const ModelTerm term : kMaterialTerms) {
        model.*traitsOf(term).option =
            choiceOf(term, scene.choices).value_or(isPossible(term, scene));
    }
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
    if (!has(model, ModelTerm::RetractWork)) {
        options.adhesionRatio = 1.0;
    }
    TimeTerms time = timeTerms(scene, material);
    if (!has(model, ModelTerm::Relaxation)) {
        time.relaxingShare = 0.0;
    }
    if (!has(model, ModelTerm::Drag)) {
        time.drag = 0.0;
    }
    return {.contact = ContactModel(model.law, contactPair(scene, material), options),
            .cantilever = believedLever(scene.probe, model),
            .friction = model.friction ? material.friction : Friction{},
            .time = time,
            .curvature = model.curvature};
}

ProbeSystem trueSystem(const SceneDescription& description) {
    const TruthDescription& truth = description.truth;
    CantileverGeometry probe = description.probe;
    probe.thickness = thicknessForStiffness(probe, truth.stiffness);
    const SampleMaterial& material = truth.material;
    return {.contact =
                ContactModel(lawFor(description, material).law, contactPair(description, material),
                             contactOptions(description, material)),
            .cantilever = Cantilever(probe),
            .friction = material.friction,
            .time = timeTerms(description, material)};
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
