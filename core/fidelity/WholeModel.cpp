#include "core/fidelity/WholeModel.h"

namespace asperity {

SceneModel wholeModel(SceneDescription scene) {
    scene.law.reset();
    scene.terms = {};
    scene.solver = SolverTier::Exact;
    scene.footSearch = FootEffort::Certified;
    return usualModel(scene);
}

std::vector<ModelTerm> missingTerms(const SceneModel& model, const SceneDescription& scene) {
    std::vector<ModelTerm> missing;
    for (const ModelTerm term : kModelTerms) {
        if (!isOfSurface(term) && !has(model, term) && isPossible(term, scene)) {
            missing.push_back(term);
        }
    }
    return missing;
}

}  // namespace asperity
