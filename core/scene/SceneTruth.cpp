#include "core/scene/SceneTruth.h"

#include "core/contact/laws/LawChoice.h"
#include "core/scene/Scene.h"

namespace asperity {

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
