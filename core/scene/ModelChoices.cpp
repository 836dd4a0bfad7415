#include "core/scene/ModelChoices.h"

#include "core/scene/ModelTerm.h"

namespace asperity {

namespace {

void free(ModelChoices& choices, ModelTerm term, bool from) {
    const auto member = traitsOf(term).choice;
    if (member != nullptr && choices.*member == from) {
        (choices.*member).reset();
    }
}

/// Takes back what is said of other terms where that leaves no law for this choice.
void freeContradicting(ModelChoices& choices, ModelTerm term, bool on) {
    if (!on) {
        if (term == ModelTerm::Adhesion) {
            free(choices, ModelTerm::VanDerWaalsTail, true);
            free(choices, ModelTerm::BodyAttraction, true);
        }
        if (term == ModelTerm::VanDerWaalsTail) {
            free(choices, ModelTerm::BodyAttraction, true);
        }
        return;
    }
    for (const ModelTerm other : kModelTerms) {
        if (exclude(term, other)) {
            free(choices, other, true);
        }
    }
    if (term == ModelTerm::BodyAttraction) {
        free(choices, ModelTerm::VanDerWaalsTail, false);
    }
    if (term == ModelTerm::VanDerWaalsTail || term == ModelTerm::BodyAttraction) {
        free(choices, ModelTerm::Adhesion, false);
    }
}

}  // namespace

ForceModelOptions optionsOf(const ModelChoices& choices) noexcept {
    ForceModelOptions options;
    options.law = choices.law.value_or(options.law);
    options.solver = choices.solver;
    options.closestPointSearch = choices.closestPointSearch.value_or(options.closestPointSearch);
    options.decoupling = choices.decoupling;
    options.deformation = choices.deformation.value_or(options.deformation);
    for (const ModelTerm term : kSwitchedTerms) {
        const ModelTermTraits& traits = traitsOf(term);
        options.*traits.option = (choices.*traits.choice).value_or(traits.usual);
    }
    return options;
}

std::optional<bool> choiceOf(ModelTerm term, const ModelChoices& choices) noexcept {
    if (const auto member = traitsOf(term).choice) {
        return choices.*member;
    }
    return isSettled(term, choices) ? std::optional(has(optionsOf(choices), term)) : std::nullopt;
}

bool isSettled(ModelTerm term, const ModelChoices& choices) noexcept {
    if (const auto member = traitsOf(term).choice) {
        return (isOfLaw(term) && choices.law) || choices.*member;
    }
    return isOfSurface(term) ? choices.deformation.has_value()
                             : choices.closestPointSearch.has_value();
}

ModelChoices withChoice(ModelChoices choices, ModelTerm term, std::optional<bool> on) noexcept {
    if (const auto member = traitsOf(term).choice) {
        if (isOfLaw(term)) {
            choices.law.reset();
        }
        if (on) {
            freeContradicting(choices, term, *on);
        }
        choices.*member = on;
        return choices;
    }
    const ForceModelOptions now = optionsOf(choices);
    const ForceModelOptions chosen = on.value_or(false) ? with(now, term) : without(now, term);
    if (isOfSurface(term)) {
        choices.deformation = on ? std::optional(chosen.deformation) : std::nullopt;
    } else {
        choices.closestPointSearch = on ? std::optional(chosen.closestPointSearch) : std::nullopt;
    }
    return choices;
}

ModelChoices withForce(ModelChoices choices, const ForceModelOptions& options) noexcept {
    choices = {.law = options.law,
               .solver = options.solver,
               .closestPointSearch = options.closestPointSearch,
               .decoupling = choices.decoupling,
               .deformation = choices.deformation};
    for (const ModelTerm term : kSwitchedTerms) {
        if (term != ModelTerm::SampleCurvature || !isSphere(options.law)) {
            choices.*traitsOf(term).choice = options.*traitsOf(term).option;
        }
    }
    return choices;
}

ModelChoices allAutomatic(const ModelChoices& choices) noexcept {
    return {.decoupling = choices.decoupling};
}

}  // namespace asperity
