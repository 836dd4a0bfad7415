#pragma once

#include "core/fidelity/FidelityTier.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/SceneDescription.h"

#include <optional>

namespace asperity {

/// What the scene itself says of a term; none: nothing, or its contact law says it.
[[nodiscard]] std::optional<bool> choiceOf(ModelTerm term, const SceneDescription& scene);

/// The scene with the term in or out; none: as it requires. What contradicts that is as the scene
/// requires, too: other terms, a contact law. The terms of the surface share one choice, the
/// deformation.
[[nodiscard]] SceneDescription withChoice(SceneDescription scene, ModelTerm term,
                                          std::optional<bool> on);

/// The scene with this way for the tick and no other.
[[nodiscard]] SceneDescription withTier(SceneDescription scene, const TickTier& tier);

/// The scene with nothing overruled.
[[nodiscard]] SceneDescription allAutomatic(SceneDescription scene);

}  // namespace asperity
