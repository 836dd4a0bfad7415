#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

/// Reads the map or shape of [sample], all but its material, over what `scene` has there.
/// @throw InputError
void readSampleKeys(TomlSection& section, SceneDescription& scene);

/// Inserts them.
void insertSampleKeys(const SceneDescription& scene, toml::table& table);

}  // namespace asperity
