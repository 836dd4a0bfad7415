#pragma once

#include "core/scene/ModelTerm.h"
#include "core/scene/SceneDescription.h"

#include <vector>

namespace asperity {

/// Every term that the law of the scene's materials has room for, whatever the scene overrules,
/// solved afresh and with the certified search for contact points. @throw Error as usualModel()
[[nodiscard]] ForceModelOptions wholeModel(SceneDescription scene);

/// Terms of the force that the sample has and the model has not.
[[nodiscard]] std::vector<ModelTerm> missingTerms(const ForceModelOptions& model,
                                                  const SceneDescription& scene);

}  // namespace asperity
