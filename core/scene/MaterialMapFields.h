#pragma once

#include "core/scene/SceneFields.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A map as a panel writes it: "film.gwy # Modulus"; empty: there is none.
[[nodiscard]] std::string mapText(const std::optional<MapSource>& source);
/// The map that such a text names. @param present stays as it is where the text is that of it
[[nodiscard]] std::optional<MapSource> mapOf(const std::string& text,
                                             const std::optional<MapSource>& present);

/// The rows of sceneFields() on the maps of a material.
/// @param access lambda without captures from a scene to the material, as in scene_field::at()
template <class Access>
std::vector<SceneField> materialMapFields(SceneGroup group, Access /*access*/) {
    const auto row = [group]<std::optional<MapSource> MaterialSources::*map>(const char* key,
                                                                             const char* caption) {
        return SceneField{.group = group,
                          .key = key,
                          .words = {caption,
                                    "Where it is not the same everywhere: a file of a map over the "
                                    "scan, and after # its channel; empty: the same everywhere"},
                          .input = SceneInput::Text,
                          .get = [](const SceneDescription& scene) -> SceneValue {
                              return mapText(Access{}(scene).maps.*map);
                          },
                          .set =
                              [](SceneDescription& scene, const SceneValue& value) {
                                  auto& present = Access{}(scene).maps.*map;
                                  present = mapOf(std::get<std::string>(value), present);
                              },
                          .ownForm = true};
    };
    return {
        row.template operator()<&MaterialSources::youngsModulus>("youngs_modulus_map",
                                                                 "Map of the modulus"),
        row.template operator()<&MaterialSources::workOfAdhesion>("work_of_adhesion_map",
                                                                  "Map of the adhesion"),
        row.template operator()<&MaterialSources::friction>("friction_map", "Map of the friction")};
}

}  // namespace asperity
