#pragma once

#include "core/scene/SceneDescription.h"

#include <filesystem>
#include <string>

namespace asperity {

/// Reads a scene (TOML); every key is documented in docs/scene.md. Paths in it are relative to it.
/// @throw InputError on a mistake, an unknown key, or a file it names that cannot be read
[[nodiscard]] SceneDescription readScene(const std::filesystem::path& path);

/// Reads the scene of a run as it was run: one of before the surface normal had a deviation has
/// none, which is 0. @throw InputError as readScene()
[[nodiscard]] SceneDescription readRecordedScene(const std::filesystem::path& path);

/// A scene from either a scene file (by content or extension) or a height map, which stands for a
/// scene with defaults.
[[nodiscard]] SceneDescription sceneFromInput(const std::filesystem::path& path);

/// The whole description as TOML text, every value spelled out: reading it back gives the same.
[[nodiscard]] std::string sceneText(const SceneDescription& scene);

/// A material file. @param notes that stand above it as comments, a line each
[[nodiscard]] std::string materialText(const SampleMaterial& material, const std::string& notes);

/// A sample from a material file. @throw InputError
[[nodiscard]] SampleMaterial readMaterialFile(const std::filesystem::path& path);

}  // namespace asperity
