#pragma once

#include "core/fidelity/ModelRun.h"
#include "core/fidelity/SurfaceNeeds.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <string>

namespace asperity {

/// What a scene and its sampled run say of a term, for people: one clause with the quantity that
/// decides. @param scene has the full model
[[nodiscard]] std::string factOf(ModelTerm term, const Scene& scene, const ModelRun& run,
                                 const SurfaceNeeds& surface);

}  // namespace asperity
