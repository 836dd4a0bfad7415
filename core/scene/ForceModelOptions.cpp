#include "core/scene/ForceModelOptions.h"

#include "core/scene/ModelTerm.h"

namespace asperity {

ForceModelOptions ofForce(ForceModelOptions options) noexcept {
    options.deformation = ForceModelOptions{}.deformation;
    options.curvature = options.curvature || isSphere(options.law);
    return options;
}

std::string nameOf(const ForceModelOptions& options) {
    std::string text = nameOf(options.law);
    text += options.solver == SolverTier::Table ? ", table" : "";
    text += options.solver == SolverTier::Exact ? ", afresh" : "";
    text += std::string(", ") + keyOf(options.closestPointSearch) + " feet";
    text += options.decoupling == DecouplingTier::Planar ? ", planar" : "";
    const char* before = ", without ";
    for (const ModelTerm term : kSwitchedTerms) {
        if (!(options.*traitsOf(term).option)) {
            text += std::string(before) + nameOf(term);
            before = ", ";
        }
    }
    return text;
}

}  // namespace asperity
