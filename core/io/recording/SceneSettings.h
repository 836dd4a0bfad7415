#pragma once

#include "core/scene/SceneDescription.h"
#include "core/scene/Settings.h"

namespace asperity {

/// The scene with the knobs as they are.
[[nodiscard]] SceneDescription withSettings(SceneDescription scene, const Settings& settings);

/// Refuses knobs that no scene may have. @throw Error naming the key of the first one
void checkSettings(const Settings& settings);

}  // namespace asperity
