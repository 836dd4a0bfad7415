#pragma once

#include "core/surface/closest/SearchReach.h"

#include <array>
#include <cstddef>

namespace asperity {

class BSplineSurface;
class ClosestPointList;

/// Completes the closest points of one query after another on ONE surface. Most cells are ruled out
/// for a ball of queries at once, so that the next ones look into the few that are left, or into
/// none. Holds proofs, no answers: a fresh tracker only takes longer, but
/// where that ends at a search's limit, it proves less.
class ClosestPointTracker {
public:
    ClosestPointTracker() noexcept;
    ClosestPointTracker(const ClosestPointTracker& other) noexcept;
    ClosestPointTracker& operator=(const ClosestPointTracker& other) noexcept;
    ~ClosestPointTracker();

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
    /// What is proven, and when to prove more: this header does not know how.
    struct Proofs;
    [[nodiscard]] Proofs& proofs() noexcept;
    [[nodiscard]] const Proofs& proofs() const noexcept;

    [[nodiscard]] SearchProof provePoints(const BSplineSurface& surface, const Vector3& query,
                                          const SearchReach& reach,
                                          ClosestPointList& points) noexcept;

    static constexpr std::size_t kProofsSize = 98'448;  ///< [bytes]
    static constexpr std::size_t kProofsAlignment = 16;

    alignas(kProofsAlignment) std::array<std::byte, kProofsSize> proofs_;
};

}  // namespace asperity
