#pragma once

#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <vector>

namespace asperity {

/// Every term that the law of the scene's materials has room for, whatever the scene overrules,
/// solved afresh and with the certified search for contact points. @throw Error as usualModel()
[[nodiscard]] ForceModelOptions wholeModel(const Scene& scene);

/// Whether a term can change anything in a scene. The attraction by the body beside a contact
/// cannot where the tip is nowhere blunt on the surface.
[[nodiscard]] bool isInScene(ModelTerm term, const Scene& scene) noexcept;

/// Terms of the force that the sample has and the model has not.
[[nodiscard]] std::vector<ModelTerm> missingTerms(const ForceModelOptions& model,
                                                  const Scene& scene);

/// A model with a term and the same without it; what excludes the term is out of both.
struct TermPair {
    ForceModelOptions with;
    ForceModelOptions without;
};

[[nodiscard]] TermPair pairOf(ModelTerm term, ForceModelOptions model);

}  // namespace asperity
