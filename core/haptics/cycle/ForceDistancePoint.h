#pragma once

#include "core/scene/TickOutput.h"

namespace asperity {

/// One tick as a point of a force-distance curve: all along the normal at the contact. Distances
/// are to the undeformed surface that the model believes in.
struct ForceDistancePoint {
    double force = 0.0;         ///< estimated, on the tip, > 0 repulsive [N]
    double sigma = 0.0;         ///< standard deviation of `force` [N]
    double separation = 0.0;    ///< of the tip as the estimate has it, < 0: indented [m]
    double baseDistance = 0.0;  ///< of the undeflected tip: what the piezo sets, without noise [m]
};

/// Whether a tick has such a point: its model state is solved and all of it is finite.
[[nodiscard]] bool hasPoint(const TickOutput& out) noexcept;

/// The point of a tick that has one.
[[nodiscard]] ForceDistancePoint forceDistancePoint(const TickOutput& out) noexcept;

}  // namespace asperity
