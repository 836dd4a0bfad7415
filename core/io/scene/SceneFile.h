#pragma once

#include "core/scene/SceneDescription.h"

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// Reads a scene (TOML); every key is documented in docs/scene.md. Paths in it are relative to it.
/// @throw InputError on a mistake, an unknown key, or a file it names that cannot be read
[[nodiscard]] SceneDescription readScene(const std::filesystem::path& path);

/// Reads the scene of a run as it was run: one of before the surface normal had a deviation has
/// none, which is 0. @throw InputError as readScene()
[[nodiscard]] SceneDescription readRecordedScene(const std::filesystem::path& path);

/// Returns whether a file is a scene, by content or extension; else it may be a height map.
[[nodiscard]] bool isScene(const std::filesystem::path& path);

/// A scene from either a scene file or a height map.
/// @param like scene whose material, tip, lever and model a height map gets; none: the defaults
[[nodiscard]] SceneDescription
sceneFromInput(const std::filesystem::path& path,
               const std::optional<SceneDescription>& like = std::nullopt);

/// The whole description as TOML text, every value spelled out: reading it back gives the same.
[[nodiscard]] std::string sceneText(const SceneDescription& scene);

/// A material file. @param notes above it as comments, a line each
[[nodiscard]] std::string materialText(const SampleMaterial& material, const std::string& notes);

/// A sample from a material file. @throw InputError
[[nodiscard]] SampleMaterial readMaterialFile(const std::filesystem::path& path);

/// Writes a scene that readScene() reads as the same. The scan is named by its path from the
/// scene's folder where they have one in common, so that both can move together. An older file
/// stays whole until the new one is.
/// @param window the section [window], which no command reads: how the window showed the scene
/// @throw FileError, Error
void saveScene(const SceneDescription& scene, const std::filesystem::path& file,
               const std::string& window = {});

}  // namespace asperity
