#pragma once

#include "core/scene/SceneFields.h"

#include <vector>

namespace asperity {

/// The rows of sceneFields() on what model and calibration leave open.
[[nodiscard]] std::vector<SceneField> uncertaintyFields();

}  // namespace asperity
