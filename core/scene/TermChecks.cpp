#include "core/scene/TermChecks.h"

#include "core/Error.h"
#include "core/scene/ModelTerm.h"

#include <string>

namespace asperity {

namespace {

[[noreturn]] void refuse(ModelTerm term, const std::string& reason) {
    throw Error(std::string("[fidelity]: ") + keyOf(term) + " cannot be on: " + reason);
}

void checkOn(const SceneDescription& scene, ModelTerm term) {
    if (!isPossible(term, scene)) {
        refuse(term, term == ModelTerm::FilmBase ? "the sample's film_thickness_m is 0"
                     : scene.sample.shape && term == ModelTerm::BodyAttraction
                         ? "the sample is a shape, which has nothing beside the contact"
                         : "the sample's work_of_adhesion_j_m2 is 0");
    }
    for (const ModelTerm other : kModelTerms) {
        if (exclude(term, other) && choiceOf(other, scene.choices) == true) {
            refuse(term, std::string(keyOf(other)) + " is on, and no contact law has both");
        }
    }
    const bool isOfTail = term == ModelTerm::BodyAttraction;
    if ((isOfTail || term == ModelTerm::VanDerWaalsTail) &&
        choiceOf(ModelTerm::Adhesion, scene.choices) == false) {
        refuse(term, "adhesion is off");
    }
    if (isOfTail && choiceOf(ModelTerm::VanDerWaalsTail, scene.choices) == false) {
        refuse(term, "van_der_waals_tail is off, of which it is a part");
    }
}

}  // namespace

void checkTerms(const SceneDescription& scene) {
    for (const ModelTerm term : kModelTerms) {
        const std::optional<bool> on = choiceOf(term, scene.choices);
        if (on && isOfLaw(term) && scene.choices.law) {
            throw Error(std::string("[fidelity]: ") + keyOf(term) +
                        " is the matter of [physics] law, which is " + keyOf(*scene.choices.law) +
                        "; leave out one of them");
        }
        if (on == true && term == ModelTerm::SampleCurvature && scene.choices.law &&
            isSphere(*scene.choices.law)) {
            refuse(term, std::string("[physics] law is ") + keyOf(*scene.choices.law) +
                             ", which takes the sample as flat");
        }
        if (on == true) {
            checkOn(scene, term);
        }
    }
}

}  // namespace asperity
