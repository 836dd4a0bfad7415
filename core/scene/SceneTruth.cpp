#include "core/scene/SceneTruth.h"

#include "core/contact/laws/LawChoice.h"

namespace asperity {

InstrumentTruth truthOf(const SceneDescription& description) {
    const TruthDescription& truth = description.truth;
    CantileverGeometry probe = description.probe;
    probe.thickness = thicknessForStiffness(probe, truth.stiffness);
    const SampleMaterial& material = truth.material;
    const ContactPair pair = contactPair(description, material);
    const LawChoice choice = chooseLaw(description.choices.law, pair, material.filmThickness);
    return {
        .system = {.contact = ContactModel(choice.law, pair, contactOptions(description, material)),
                   .cantilever = Cantilever(probe),
                   .friction = material.friction},
        .noise = {.bending = truth.signalNoise, .torsion = truth.signalNoise},
        .seed = truth.noiseSeed,
        .temperature = truth.temperature,
        .timeStep = 1.0 / description.tickRate};
}

}  // namespace asperity
