#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// A path as text for JSON and TOML, which hold UTF-8 only. Most paths stand as they are. One that
/// is no UTF-8, or that would read as a URI, stands as the file URI of its absolute path (RFC 8089,
/// "file:///scans/25%B5m.gsf"), so that no byte is lost.
[[nodiscard]] std::string pathText(const std::filesystem::path& path);

/// The path that a text stands for: a file URI of this machine, or the path itself.
/// @return empty when the text begins as a file URI and is none ("%" without two digits, "%00")
[[nodiscard]] std::optional<std::filesystem::path> pathFromText(std::string_view text);

}  // namespace asperity
