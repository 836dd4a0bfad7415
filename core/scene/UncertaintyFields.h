#pragma once

#include "core/scene/SceneFields.h"

#include <vector>

namespace asperity {

/// The rows of sceneFields() on the uncertainty of model and calibration. A file of their own: they
/// follow from kEnumTable<UncertaintyInput> by a template, where the others are written out.
[[nodiscard]] std::vector<SceneField> uncertaintyFields();

}  // namespace asperity
