#pragma once

#include "core/probe/SimulatedAfm.h"
#include "core/scene/Scene.h"

namespace asperity {

/// What the simulated instrument of a scene is: what its description says is true, whatever the
/// model believes.
/// @throw Error where no such instrument can be; buildScene() has looked
[[nodiscard]] InstrumentTruth truthOf(const SceneDescription& description);
[[nodiscard]] inline InstrumentTruth truthOf(const Scene& scene) {
    return truthOf(scene.description);
}

}  // namespace asperity
