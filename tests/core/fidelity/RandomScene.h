#pragma once

#include "core/Random.h"
#include "core/scene/Scene.h"

namespace asperity::test {

/// A scene of 48 x 48 pixels with random roughness, materials, tip, lever and tilt; all that
/// SceneNeeds decides is left to it.
[[nodiscard]] Scene randomScene(Random& random);

}  // namespace asperity::test
