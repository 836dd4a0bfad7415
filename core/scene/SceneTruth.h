#pragma once

#include "core/probe/SimulatedAfm.h"
#include "core/scene/Scene.h"

namespace asperity {

/// What the simulated instrument of a scene is: what its description says is true, whatever the
/// model believes.
[[nodiscard]] InstrumentTruth truthOf(const Scene& scene);

}  // namespace asperity
