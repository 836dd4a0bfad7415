#pragma once

#include "core/haptics/HandPath.h"
#include "core/io/tables/CsvTable.h"

#include <filesystem>

namespace asperity {

/// Reads a hand's path from CSV with the columns time_s, x_m, y_m, z_m (world frame).
/// @throw InputError when a value is missing or not finite, or time does not rise
[[nodiscard]] HandPath readHandPath(const std::filesystem::path& path);

/// The way of the base in a recorded force log. @throw InputError as readHandPath()
[[nodiscard]] HandPath readRecordedPath(const CsvTable& forceLog);

}  // namespace asperity
