#include "core/fidelity/ReferenceModels.h"

#include "core/scene/BelievedModel.h"

namespace asperity {

ForceModelOptions wholeModel(SceneDescription scene) {
    scene.choices = {.solver = SolverSetting::Exact,
                     .closestPointSearch = SearchEffort::Certified,
                     .decoupling = scene.choices.decoupling,
                     .deformation = scene.choices.deformation};
    return usualModel(scene);
}

std::vector<ModelTerm> missingTerms(const ForceModelOptions& model, const SceneDescription& scene) {
    std::vector<ModelTerm> missing;
    for (const ModelTerm term : kModelTerms) {
        if (!isOfSurface(term) && !has(model, term) && isPossible(term, scene)) {
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
