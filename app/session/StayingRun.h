#pragma once

#include "core/Progress.h"

#include <filesystem>

namespace asperity {

/// The folder of a run that a user names by it, or by a bundle. A bundle is unpacked among the
/// user's own data, where it stays: a session may name its scan.
/// @throw InputError where it is neither; Error; Canceled
[[nodiscard]] std::filesystem::path stayingRun(const std::filesystem::path& input,
                                               Progress* progress = nullptr);

}  // namespace asperity
