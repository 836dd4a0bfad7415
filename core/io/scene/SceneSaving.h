#pragma once

#include "core/scene/SceneDescription.h"

#include <filesystem>

namespace asperity {

/// Writes a scene that readScene() reads as the same. The scan is named by its way from the scene's
/// folder where they have one in common, so that both can move together. An older file stays whole
/// until the new one is. @throw FileError, Error
void saveScene(const SceneDescription& scene, const std::filesystem::path& file);

}  // namespace asperity
