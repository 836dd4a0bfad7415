#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

/// The section [haptics] of a scene file: rate, gains, coupling, governor, clutch and guide.
/// @throw InputError
void readHaptics(TomlSection section, SceneDescription& scene);

/// The same section, every value spelled out.
[[nodiscard]] toml::table hapticsTable(const SceneDescription& scene);

}  // namespace asperity
