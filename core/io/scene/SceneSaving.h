#pragma once

#include "core/scene/SceneDescription.h"

#include <filesystem>
#include <string>

namespace asperity {

/// Writes a scene that readScene() reads as the same. The scan is named by its way from the scene's
/// folder where they have one in common, so that both can move together. An older file stays whole
/// until the new one is.
/// @param window the section [window], which no command reads: how the window showed the scene
/// @throw FileError, Error
void saveScene(const SceneDescription& scene, const std::filesystem::path& file,
               const std::string& window = {});

}  // namespace asperity
