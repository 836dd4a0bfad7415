#pragma once

#include "core/probe/SimulatedAfm.h"

namespace asperity {

struct Scene;
struct SceneDescription;

/// Tip, lever and sample as a description says that they truly are.
/// @throw Error naming what the contact law or the lever refuses
[[nodiscard]] ProbeSystem trueSystem(const SceneDescription& description);

/// What the simulated instrument of a scene is: what its description says is true, whatever the
/// model believes.
[[nodiscard]] InstrumentTruth truthOf(const Scene& scene);

}  // namespace asperity
