#pragma once

#include <filesystem>

namespace asperity {

/// Prints how long each real file, and large ones of the formats that need most work, take to be
/// read by Asperity and by Gwyddion.
/// @param folder of the real files, ../shared/data/afm
void measureFormats(const std::filesystem::path& folder);

}  // namespace asperity
