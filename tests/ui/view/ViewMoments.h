#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/scene/Scene.h"

namespace asperity::test {

/// What is worth seeing of a run that approaches, indents and retracts.
struct ViewMoments {
    Snapshot away;  ///< at the beginning
    Snapshot deep;  ///< largest indentation
    Snapshot neck;  ///< last one before pull-off
};

/// @param indentation of the base below first contact [m]
[[nodiscard]] ViewMoments momentsOf(const Scene& scene, double indentation = 3e-9);

/// The same tick with tip and contact elsewhere on a level surface.
[[nodiscard]] Snapshot movedBy(Snapshot snapshot, const Vector3& way);

[[nodiscard]] Scene flatScene();
[[nodiscard]] Scene hillyScene();

}  // namespace asperity::test
