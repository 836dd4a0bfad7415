#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneFields.h"

namespace asperity {

/// Reads one key of sceneFields() over what the scene has; a key that the section lacks changes
/// nothing. @throw InputError naming the key and what it must be
void readKey(TomlSection& section, const SceneField& field, SceneDescription& scene);

/// Reads the keys of a group, but those of a form of their own (SceneField::ownForm). One that
/// means nothing for the sample of the scene, such as the radius of a plane, is refused.
/// @throw InputError naming the key
void readKeys(TomlSection& section, SceneGroup group, SceneDescription& scene);

/// Returns the number of a key, or `otherwise` where the section lacks it [SI].
/// @throw InputError where it is outside the limits of the field
[[nodiscard]] double readNumber(TomlSection& section, const SceneField& field, double otherwise);

/// Inserts one key as readKey() reads it, unless the scene leaves it open.
void insertKey(const SceneField& field, const SceneDescription& scene, toml::table& table);

/// Inserts the keys that readKeys() reads.
void insertKeys(SceneGroup group, const SceneDescription& scene, toml::table& table);

}  // namespace asperity
