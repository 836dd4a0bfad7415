#pragma once

#include "core/scene/SceneFields.h"

#include <string>

namespace asperity {

/// What a change of a key is called: "Tip radius: 20 nm", "Leveling: plane, quadratic".
/// @param scene that has the new value
[[nodiscard]] std::string changeText(const SceneField& field, const SceneDescription& scene);

}  // namespace asperity
