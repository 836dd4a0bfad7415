#include "core/scene/TermChecks.h"

#include "core/Error.h"
#include "core/scene/ModelTerm.h"

#include <string>

namespace asperity {

namespace {

std::optional<bool> choice(const SceneDescription& scene, ModelTerm term) {
    const auto member = choiceMember(term);
    return member ? scene.terms.*member : std::nullopt;
}

[[noreturn]] void refuse(ModelTerm term, const std::string& reason) {
    throw Error(std::string("[fidelity]: ") + keyOf(term) + " cannot be on: " + reason);
}

void checkOn(const SceneDescription& scene, ModelTerm term) {
    if (!isPossible(term, scene)) {
        refuse(term, term == ModelTerm::FilmBase ? "the sample's film_thickness_m is 0"
                                                 : "the sample's work_of_adhesion_j_m2 is 0");
    }
    for (const ModelTerm other : kModelTerms) {
        if (exclude(term, other) && choice(scene, other) == true) {
            refuse(term, std::string(keyOf(other)) + " is on, and no contact law has both");
        }
    }
    if (term == ModelTerm::VanDerWaalsTail && choice(scene, ModelTerm::Adhesion) == false) {
        refuse(term, "adhesion is off");
    }
}

}  // namespace

void checkTerms(const SceneDescription& scene) {
    for (const ModelTerm term : kModelTerms) {
        const std::optional<bool> on = choice(scene, term);
        if (on && isOfLaw(term) && scene.law) {
            throw Error(std::string("[fidelity]: ") + keyOf(term) +
                        " is the matter of [physics] law, which is " + keyOf(*scene.law) +
                        "; leave out one of them");
        }
        if (on == true && term == ModelTerm::SampleCurvature && scene.law && isSphere(*scene.law)) {
            refuse(term, std::string("[physics] law is ") + keyOf(*scene.law) +
                             ", which takes the sample as flat");
        }
        if (on == true) {
            checkOn(scene, term);
        }
    }
}

}  // namespace asperity
