#pragma once

#include "core/Progress.h"
#include "core/scene/Scene.h"
#include "core/surface/HeightMap.h"

#include <string>
#include <variant>

namespace asperity {

/// A scene under other heights than its own file's: tip, lever, material, leveling and smoothing
/// are those of the scene, which takes all pixels that it is given.
/// @param file of the scene; empty: the scene that a height map alone stands for
/// @throw InputError; Error when the sample of the scene is a shape; Canceled
[[nodiscard]] Scene sceneOf(const std::string& file, std::variant<HeightMap, ScanMap> heights,
                            Progress* progress);

/// The scene of a scene file, or of a height map alone, on its own sample.
/// @throw InputError; Error; Canceled
[[nodiscard]] Scene sceneOf(const std::string& file, Progress* progress);

}  // namespace asperity
