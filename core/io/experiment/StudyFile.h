#pragma once

#include "core/experiment/Study.h"

#include <filesystem>

namespace asperity {

/// Reads a study (TOML); every key is documented in docs/study.md. Paths in it are relative to it.
/// @throw InputError on a mistake, an unknown key, a study that contradicts itself, or a file that
/// it names and that cannot be read
[[nodiscard]] Study readStudy(const std::filesystem::path& path);

/// Writes `study.toml` into a folder with all that it names beside it: scene, materials, levers.
/// Reading it gives the same study. @throw Error, FileError
void writeStudy(const Study& study, const std::filesystem::path& folder);

}  // namespace asperity
