#pragma once

#include "core/scene/SceneFields.h"

#include <string>

namespace asperity {

/// The value of a key in the unit of its words: "20 nm", "on", "plane, quadratic".
/// @param scene that has it
[[nodiscard]] std::string valueText(const SceneField& field, const SceneDescription& scene);

/// What a change of a key is called: "Tip radius: 20 nm", "Leveling: plane, quadratic".
/// @param scene that has the new value
[[nodiscard]] std::string changeText(const SceneField& field, const SceneDescription& scene);

}  // namespace asperity
