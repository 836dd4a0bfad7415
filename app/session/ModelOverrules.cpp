#include "app/session/ModelOverrules.h"

namespace asperity {

namespace {

void free(TermChoices& terms, ModelTerm term, bool from) {
    const auto member = choiceMember(term);
    if (member && terms.*member == from) {
        (terms.*member).reset();
    }
}

/// Takes back what the scene says of other terms where that leaves no law for this choice.
void freeContradicting(TermChoices& terms, ModelTerm term, bool on) {
    if (!on) {
        if (term == ModelTerm::Adhesion) {
            free(terms, ModelTerm::VanDerWaalsTail, true);
        }
        return;
    }
    for (const ModelTerm other : kModelTerms) {
        if (exclude(term, other)) {
            free(terms, other, true);
        }
    }
    if (term == ModelTerm::VanDerWaalsTail) {
        free(terms, ModelTerm::Adhesion, false);
    }
}

}  // namespace

std::optional<bool> choiceOf(ModelTerm term, const SceneDescription& scene) {
    if (const auto member = choiceMember(term)) {
        return scene.terms.*member;
    }
    if (!isSettled(term, scene)) {
        return std::nullopt;
    }
    const SceneModel all;
    return has({.footSearch = scene.footSearch.value_or(all.footSearch),
                .deformation = scene.deformation.value_or(all.deformation)},
               term);
}

SceneDescription withChoice(SceneDescription scene, ModelTerm term, std::optional<bool> on) {
    if (const auto member = choiceMember(term)) {
        if (isOfLaw(term)) {
            scene.law.reset();
        }
        if (on) {
            freeContradicting(scene.terms, term, *on);
        }
        scene.terms.*member = on;
        return scene;
    }
    SceneModel model;
    model.footSearch = scene.footSearch.value_or(model.footSearch);
    model.deformation = scene.deformation.value_or(model.deformation);
    if (on && *on != has(model, term)) {
        model = *on ? with(model, term) : without(model, term);
    }
    if (isOfSurface(term)) {
        scene.deformation = on ? std::optional(model.deformation) : std::nullopt;
    } else {
        scene.footSearch = on ? std::optional(model.footSearch) : std::nullopt;
    }
    return scene;
}

SceneDescription withTier(SceneDescription scene, const TickTier& tier) {
    scene.law = tier.law;
    scene.terms = {.friction = tier.friction, .torsion = tier.torsion, .mountTilt = tier.mountTilt};
    if (!isSphere(tier.law)) {
        scene.terms.curvature = tier.curvature;
    }
    scene.solver = tier.solver;
    scene.footSearch = tier.footSearch;
    return scene;
}

SceneDescription allAutomatic(SceneDescription scene) {
    scene.law.reset();
    scene.solver = SceneDescription{}.solver;
    scene.footSearch.reset();
    scene.deformation.reset();
    scene.terms = {};
    return scene;
}

}  // namespace asperity
