#pragma once

#include "ui/measure/Touch.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Writes touches as a CSV table in SI units, one row each; a cell is empty where the touch has no
/// such value. Columns are named as the keys of `cycles` in summary.json (docs/measuring.md).
/// @throw Error when it cannot be written; then the file stays as it was
void writeTouches(const std::filesystem::path& file, const std::vector<Touch>& touches);

}  // namespace asperity
