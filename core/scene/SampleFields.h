#pragma once

#include "core/scene/SceneFields.h"

#include <vector>

namespace asperity {

/// The rows of sceneFields() on the map of a scan and what is done to it.
[[nodiscard]] std::vector<SceneField> sampleFields();

/// Returns the fields of a shape instead of a map.
[[nodiscard]] std::vector<SceneField> shapeFields();

}  // namespace asperity
