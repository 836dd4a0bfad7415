#include "core/fidelity/WholeModel.h"

#include "core/scene/BelievedModel.h"

namespace asperity {

ForceModelOptions wholeModel(SceneDescription scene) {
    scene.choices = {.solver = SolverTier::Exact,
                     .footSearch = FootEffort::Certified,
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

}  // namespace asperity
