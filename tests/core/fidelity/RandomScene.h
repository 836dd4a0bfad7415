#pragma once

#include "core/Random.h"
#include "core/fidelity/ModelRun.h"
#include "core/scene/Scene.h"

#include <vector>

namespace asperity::test {

/// A scene of 48 x 48 pixels with random roughness, materials, tip, lever and tilt; all that
/// RequiredTerms decides is left to it.
[[nodiscard]] Scene randomScene(Random& random);

/// Approaches at three positions that fitModel() does not look at.
[[nodiscard]] std::vector<ModelInputs> runsElsewhere(const Scene& scene);

}  // namespace asperity::test
