#pragma once

#include "core/Vector.h"

#include <QVariantMap>

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// State of the window with a scene, as the section [window] of a scene's file: the file of a
/// session is a scene that every command accepts.

/// @param kept logical values, numbers, texts, bytes, and lists of these
[[nodiscard]] std::string windowSection(const QVariantMap& kept);
/// Returns the state with the current names of keys and of pages, where a former program kept it.
[[nodiscard]] QVariantMap withCurrentNames(const QVariantMap& kept);
/// @return empty where the file has none, or is no such file
[[nodiscard]] QVariantMap windowSectionOf(const std::filesystem::path& file);

/// Returns the tip's position, world x, y [m].
[[nodiscard]] std::optional<Vector2> keptTip(const QVariantMap& kept);
void keepTip(const Vector2& position, QVariantMap& kept);

}  // namespace asperity
