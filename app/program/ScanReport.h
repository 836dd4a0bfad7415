#pragma once

#include "app/program/LoadedScene.h"

#include <string>

namespace asperity {

/// All that is known of the scan that a scene stands on, and what was done to it: file, format,
/// hash, channel, pixels, crop, leveling, notes, and where the numbers come from. Lines of text for
/// people; what is quoted from the file is printable.
[[nodiscard]] std::string scanReport(const LoadedScene& loaded);

}  // namespace asperity
