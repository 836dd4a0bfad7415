#pragma once

#include "core/surface/foot/FootSearch.h"

namespace asperity {

/// Completes the feet of one query after another on ONE surface. Where a foot stands alone, this is
/// proven for a ball of queries at once, so that the next ones need no look. Holds proofs, no
/// answers: a fresh tracker only takes longer.
class FootTracker {
public:
    /// As completeFeet() of FootSearch.h where `effort` is Certified. With Global only a nearer
    /// foot is looked for, and the proof is Likely; with Local nothing is, and it is NotSought.
    /// Where the scan is so gentle that a foot stands alone anyway, it is Nearest with any effort.
    [[nodiscard]] FootProof completeFeet(const BSplineSurface& surface, const Vector3& query,
                                         const FootReach& reach, FootEffort effort,
                                         FootList& feet) noexcept;

private:
    [[nodiscard]] FootProof proveFeet(const BSplineSurface& surface, const Vector3& query,
                                      const FootReach& reach, FootList& feet) noexcept;

    ProvenBall ball_;
    int rest_ = 0;  ///< queries, the last time that no ball was proven
    int untilNextTry_ = 0;
};

}  // namespace asperity
