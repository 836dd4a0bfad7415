#pragma once

#include "core/Progress.h"
#include "core/deformation/HalfSpaceAnswer.h"

#include <span>

namespace asperity {

struct Scene;

/// What the ways to deform the surface differ by in a scene. Differences are root mean squares over
/// the patches of some contacts, as shares of their indentation.
struct SurfaceNeeds {
    bool touches = false;         ///< whether any of the states was a contact
    bool halfSpaceHolds = false;  ///< at all states that were looked at
    HalfSpaceAnswer deepest;      ///< what the half-space says of itself at the deepest
    double outside = 0.0;         ///< contact radius from closed form
    double halfSpace = 0.0;       ///< closed form from half-space; 0 where that does not hold
    double outsideTime = 0.0;     ///< that the closed form takes longer than the contact radius [s]
    double halfSpaceTime = 0.0;   ///< that a solution of the half-space takes [s]
};

/// Looks at the states with the largest forces.
/// @param progress may be null @throw Canceled
[[nodiscard]] SurfaceNeeds surfaceNeedsOf(const Scene& scene, std::span<const TipState> states,
                                          Progress* progress = nullptr);

}  // namespace asperity
