#pragma once

#include "core/fidelity/SceneNeeds.h"

#include <string>
#include <vector>

namespace asperity {

/// What the sample is: its file and channel, or its shape.
[[nodiscard]] std::string sampleName(const SampleDescription& sample);

/// What was decided about a scene that was loaded, one sentence each: its heights, its contact law,
/// its model.
[[nodiscard]] std::vector<std::string> sceneNotes(const Scene& scene, const SceneNeeds& needs);

}  // namespace asperity
