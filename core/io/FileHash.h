#pragma once

#include <filesystem>
#include <string>

namespace asperity {

/// SHA-256 of a file's content, 64 lower-case hexadecimal digits.
/// @throw InputError when the file cannot be read
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& path);

}  // namespace asperity
