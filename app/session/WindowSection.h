#pragma once

#include "core/Vector.h"

#include <QVariantMap>

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// How the window showed a scene, as the section [window] of a scene's file: the file of a session
/// is a scene that every command takes.

/// @param kept logical values, numbers, texts, bytes, and lists of these
[[nodiscard]] std::string windowSection(const QVariantMap& kept);
/// @return empty where the file has none, or is no such file
[[nodiscard]] QVariantMap windowSectionOf(const std::filesystem::path& file);

/// Where the tip was, world x, y [m].
[[nodiscard]] std::optional<Vector2> tipPlaceIn(const QVariantMap& kept);
void keepTipPlace(const Vector2& place, QVariantMap& kept);

}  // namespace asperity
