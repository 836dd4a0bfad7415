#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/scene/MaterialSources.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/SceneFields.h"

#include <filesystem>
#include <functional>
#include <toml++/toml.h>
#include <vector>

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

/// The section [haptics] of a scene file: rate, gains, coupling, governor, clutch and guide.
/// @throw InputError
void readHaptics(TomlSection section, SceneDescription& scene);

/// The same section, every value spelled out.
[[nodiscard]] toml::table hapticsTable(const SceneDescription& scene);

/// Name of the list of markers in scene files: [[marker]].
inline constexpr const char* kMarkers = "marker";

/// The markers of a scene file, in its order. @throw InputError
[[nodiscard]] std::vector<Marker> readMarkers(const toml::table& scene,
                                              const std::filesystem::path& path);

/// Writes them, where there are any.
void insertMarkers(const std::vector<Marker>& markers, toml::table& scene);

/// A material file as a mask's two are given.
using MaterialReader = std::function<MaskedMaterial(const std::filesystem::path&)>;

/// The keys of a section of a material on its maps; none where it has none of them.
/// @throw InputError
[[nodiscard]] MaterialSources readMaterialSources(TomlSection& section, const MaterialReader& read);
/// Returns the sources of the section [truth]; the believed ones where it has neither number nor
/// map. @param own that the section has
[[nodiscard]] MaterialSources trueSources(const TomlSection& section, MaterialSources own,
                                          const MaterialSources& believed);
void insertMaterialSources(const MaterialSources& sources, toml::table& table);

/// Reads the map or shape of [sample], all but its material, over what `scene` has there.
/// @throw InputError
void readSampleKeys(TomlSection& section, SceneDescription& scene);

/// Inserts them.
void insertSampleKeys(const SceneDescription& scene, toml::table& table);

}  // namespace asperity
