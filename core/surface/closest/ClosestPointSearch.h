#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPoint.h"
#include "core/surface/closest/ClosestPointTracker.h"

namespace asperity {

/// The surface point nearest to `query`, whatever the guess, which only saves time. Where several
/// are as near (to kSameDistance) it is one of them. Its proof says whether it is certain.
/// Allocation-free, bounded, never throws.
[[nodiscard]] ClosestPoint closestPoint(const BSplineSurface& surface, const Vector3& query,
                                        const SearchGuess& guess) noexcept;

/// The same for one query after another, each near the last; with less effort than Certified not
/// whatever the guess.
[[nodiscard]] ClosestPoint closestPoint(const BSplineSurface& surface, const Vector3& query,
                                        const SearchGuess& guess, ClosestPointTracker& tracker,
                                        SearchEffort effort = SearchEffort::Certified) noexcept;

}  // namespace asperity
