#pragma once

#include "core/scene/SceneDescription.h"

namespace asperity {

/// Whether one model can have all that the scene says of its terms.
/// @throw Error naming the first key that contradicts another, the contact law or the material
void checkTerms(const SceneDescription& scene);

}  // namespace asperity
