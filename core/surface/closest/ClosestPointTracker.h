#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPointList.h"

#include <array>
#include <cstddef>
#include <optional>

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
    /// is NotSought. Where the scan is so gentle that a closest point is alone anyway, it is
    /// Nearest with any effort.
    [[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                             const SearchReach& reach, SearchEffort effort,
                                             ClosestPointList& points) noexcept;

    /// Returns whether the closest point known is the only one within reach, as completePoints()
    /// would find, without a look at the surface.
    [[nodiscard]] bool settles(const BSplineSurface& surface, const Vector3& query,
                               const SearchReach& reach, SearchEffort effort,
                               const ClosestPoint& nearest) const noexcept;

private:
    /// State of the proofs, and when to prove more; defined in the source.
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

/// The pixel likeliest to lead downhill to the position that comes nearest to `query`: of those
/// whose centers lie within `distance` [m] of it as seen from above, at most 15 to each side, the
/// one from which a step within the pixel would leave the least distance. A sample says nothing of
/// what lies between the pixels. In a time that grows with the pixels looked at, about a nanosecond
/// each. Allocation-free.
/// @return its center, world x, y [m]; none where no pixel lies within the distance
[[nodiscard]] std::optional<Vector2> nearestSample(const BSplineSurface& surface,
                                                   const Vector3& query, double distance) noexcept;

}  // namespace asperity
