#pragma once

#include <filesystem>
#include <vector>

namespace asperity {

/// The folder `data` that belongs to this program: what ASPERITY_DATA names, else the nearest one
/// above the program itself. Empty when there is none.
[[nodiscard]] std::filesystem::path dataFolder();

/// The files of a kind ("materials", "scenes") in the data folder, by name.
[[nodiscard]] std::vector<std::filesystem::path> dataFiles(const std::filesystem::path& kind);

/// The scene that the program opens by itself; empty when there is none.
[[nodiscard]] std::filesystem::path defaultSceneFile();

}  // namespace asperity
