#include "core/fidelity/ReferenceModels.h"

#include "core/scene/BelievedModel.h"

namespace asperity {

ForceModelOptions wholeModel(const Scene& scene) {
    SceneDescription description = scene.description;
    description.choices = {.solver = SolverSetting::Exact,
                           .closestPointSearch = SearchEffort::Certified,
                           .decoupling = description.choices.decoupling,
                           .deformation = description.choices.deformation};
    ForceModelOptions model = usualModel(description);
    model.bodyAttraction = isInScene(ModelTerm::BodyAttraction, scene);
    return model;
}

bool isInScene(ModelTerm term, const Scene& scene) noexcept {
    return isPossible(term, scene.description) &&
           (term != ModelTerm::BodyAttraction || scene.moments != nullptr);
}

std::vector<ModelTerm> missingTerms(const ForceModelOptions& model, const Scene& scene) {
    std::vector<ModelTerm> missing;
    for (const ModelTerm term : kModelTerms) {
        if (!isOfSurface(term) && !has(model, term) && isInScene(term, scene)) {
            missing.push_back(term);
        }
    }
    return missing;
}

TermPair pairOf(ModelTerm term, ForceModelOptions model) {
    for (const ModelTerm other : kModelTerms) {
        model = exclude(term, other) ? without(model, other) : model;
    }
    const ForceModelOptions in = with(model, term);
    return {in, without(in, term)};
}

}  // namespace asperity
