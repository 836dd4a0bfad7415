#pragma once

#include "core/scene/SceneDescription.h"

#include <cstdint>

namespace asperity {

/// What must be made anew where a scene gets another description.
enum class SceneChange : std::uint8_t {
    None,     ///< nothing: it is the same
    Shown,    ///< nothing that acts: markers, view, setpoint, knobs that a run starts with
    Model,    ///< tip, lever, material or model, on the surface that is there
    Surface,  ///< the surface and the maps of its materials, from files or the shape
};

/// @param from of the scene that is there
[[nodiscard]] SceneChange changeBetween(const SceneDescription& from, const SceneDescription& to);

/// Gives a scene that is in use what changeBetween() calls Shown; the rest stays.
void adoptShown(SceneDescription& scene, const SceneDescription& from);

}  // namespace asperity
