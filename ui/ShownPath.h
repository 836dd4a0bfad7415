#pragma once

#include <QString>

#include <filesystem>

namespace asperity {

/// A path for people: on one line, see printable().
[[nodiscard]] QString shownPath(const std::filesystem::path& path);

/// The path that a file dialog returned, in the bytes of the file system.
[[nodiscard]] std::filesystem::path pathOf(const QString& file);

}  // namespace asperity
