#pragma once

#include "core/scene/ModelTerm.h"
#include "core/scene/SceneModel.h"

namespace asperity {

/// A model with a term and the same without it; what excludes the term is out of both.
struct TermPair {
    SceneModel with;
    SceneModel without;
};

[[nodiscard]] TermPair pairOf(ModelTerm term, SceneModel model);

}  // namespace asperity
