#include "core/fidelity/TermPair.h"

#include <utility>

namespace asperity {

TermPair pairOf(ModelTerm term, ForceModelOptions model) {
    for (const ModelTerm other : kModelTerms) {
        model = exclude(term, other) ? without(std::move(model), other) : model;
    }
    const ForceModelOptions in = with(model, term);
    return {in, without(in, term)};
}

}  // namespace asperity
