#pragma once

#include "core/scene/ModelTerm.h"

namespace asperity {

/// A model with a term and the same without it; what excludes the term is out of both.
struct TermPair {
    ForceModelOptions with;
    ForceModelOptions without;
};

[[nodiscard]] TermPair pairOf(ModelTerm term, ForceModelOptions model);

}  // namespace asperity
