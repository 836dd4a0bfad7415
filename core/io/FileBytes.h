#pragma once

#include <filesystem>
#include <string>

namespace asperity {

/// The whole content of a file.
/// @throw InputError when it is missing, a folder, no regular file, unreadable or empty
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path);

}  // namespace asperity
