#pragma once

#include "core/haptics/DevicePath.h"
#include "core/io/tables/CsvTable.h"

#include <filesystem>

namespace asperity {

/// Reads a device's path from CSV with the columns time_s, x_m, y_m, z_m (world frame).
/// @throw InputError when a value is missing or not finite, or time does not rise
[[nodiscard]] DevicePath readDevicePath(const std::filesystem::path& path);

/// The path of the base in a recorded force log. @throw InputError as readDevicePath()
[[nodiscard]] DevicePath readRecordedPath(const CsvTable& forceLog);

}  // namespace asperity
