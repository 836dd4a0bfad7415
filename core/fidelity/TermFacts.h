#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <string>

namespace asperity {

/// What a scene and a run of it say of a term of the force, for people: one clause with the
/// quantity that decides. @param scene has the model of the run, the term in
[[nodiscard]] std::string factOf(ModelTerm term, const Scene& scene, const ModelRun& run);

/// Why a term of the force is not possible in a scene, for people.
[[nodiscard]] std::string whyImpossible(ModelTerm term);

}  // namespace asperity
