#include "core/uncertainty/PlaceNumbers.h"

#include "core/contact/laws/LawChoice.h"

namespace asperity {

namespace {

ContactModel withCohesiveRange(const SceneDescription& scene, const ContactModel& model,
                               const PlaceNumbers& numbers) {
    if (!numbers.cohesiveRange) {
        return model;
    }
    ContactOptions options = contactOptions(scene, scene.sample.material);
    options.cohesiveStress /= *numbers.cohesiveRange;
    options.solver = SolverSetting::Exact;
    return ContactModel(model.law(), model.pair(), options);
}

}  // namespace

bool hasCohesiveRange(const ContactModel& model) noexcept {
    const LawTraits& law = traitsOf(model.law());
    return law.attraction == Attraction::Zone && !law.tail;
}

ContactModel withNumbers(const SceneDescription& scene, const ContactModel& model, ContactPair pair,
                         const PlaceNumbers& numbers) {
    const Elastic& tip = scene.tip.elastic;
    const Elastic& sample = scene.sample.material.elastic;
    Elastic moved = sample;
    moved.youngsModulus *= numbers.modulus;
    pair.reducedModulus *= reducedModulus(moved, tip) / reducedModulus(sample, tip);
    pair.workOfAdhesion *= numbers.workOfAdhesion;
    return withCohesiveRange(scene, model, numbers).withPair(pair);
}

}  // namespace asperity
