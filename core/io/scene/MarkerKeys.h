#pragma once

#include "core/scene/Marker.h"

#include <filesystem>
#include <toml++/toml.h>
#include <vector>

namespace asperity {

/// How scene files call the list of markers: [[marker]].
inline constexpr const char* kMarkers = "marker";

/// The markers of a scene file, in its order. @throw InputError
[[nodiscard]] std::vector<Marker> readMarkers(const toml::table& scene,
                                              const std::filesystem::path& path);

/// Writes them, where there are any.
void insertMarkers(const std::vector<Marker>& markers, toml::table& scene);

}  // namespace asperity
