#pragma once

#include "core/surface/closest/ExhaustiveSearch.h"

namespace asperity {

/// Completes the closest points of one query after another on ONE surface. Most cells are ruled out
/// for a ball of queries at once, so that the next ones look into the few that are left, or into
/// none. Holds proofs, no answers: a fresh tracker only takes longer, but
/// where that ends at a search's limit, it proves less.
class ClosestPointTracker {
public:
    /// As completePoints() of ExhaustiveSearch.h where `effort` is Certified. With Global only a
    /// nearer closest point is looked for, and the proof is Likely; with Local nothing is, and it
    /// is NotSought. Where the scan is so gentle that a closest point stands alone anyway, it is
    /// Nearest with any effort.
    [[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                             const SearchReach& reach, SearchEffort effort,
                                             ClosestPointList& points) noexcept;

    /// Whether the closest point known is the only one within reach, as completePoints() would find
    /// without a look at the surface.
    [[nodiscard]] bool settles(const BSplineSurface& surface, const Vector3& query,
                               const SearchReach& reach, SearchEffort effort,
                               const ClosestPoint& nearest) const noexcept;

private:
    [[nodiscard]] SearchProof provePoints(const BSplineSurface& surface, const Vector3& query,
                                          const SearchReach& reach,
                                          ClosestPointList& points) noexcept;

    ProvenBall ball_;
    int rest_ = 0;  ///< queries, the last time that no ball was proven
    int untilNextTry_ = 0;
};

}  // namespace asperity
