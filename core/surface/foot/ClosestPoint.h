#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/FootTracker.h"
#include "core/surface/foot/SurfaceFoot.h"

namespace asperity {

/// The surface point nearest to `query`, whatever the guess, which only saves time. Where several
/// are as near (to kSameDistance) it is one of them. Its proof says whether it is certain.
/// Allocation-free, bounded, never throws.
[[nodiscard]] SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                                       const FootGuess& guess) noexcept;

/// The same for one query after another, each near the last; with less effort than Certified not
/// whatever the guess.
[[nodiscard]] SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                                       const FootGuess& guess, FootTracker& tracker,
                                       FootEffort effort = FootEffort::Certified) noexcept;

}  // namespace asperity
