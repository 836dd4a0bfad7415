#pragma once

#include "core/Progress.h"

#include <filesystem>
#include <string>

namespace asperity {

/// SHA-256 of a file's content, 64 lower-case hexadecimal digits.
/// @throw InputError when the file cannot be read; Cancelled
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& path,
                                       Progress* progress = nullptr);

}  // namespace asperity
