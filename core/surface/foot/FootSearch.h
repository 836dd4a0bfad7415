#pragma once

#include "core/Vector.h"
#include "core/surface/foot/Box.h"
#include "core/surface/foot/FootReach.h"

namespace asperity {

class BSplineSurface;
class FootList;

/// Looks everywhere for feet of `query`: local minima of its distance from the surface within
/// `reach`, and adds them to `feet`, which holds at least one local foot already.
///
/// Cells that lie too far, or around a known foot where the distance can only grow, are ruled out
/// by their bounds; the others are quartered until the distance has no minimum in them, or one that
/// is found. @return Nearest: the list is complete, as far as it has room; ManyFeet: it need not
/// be. Allocation-free, bounded, never throws.
[[nodiscard]] FootProof completeFeet(const BSplineSurface& surface, const Vector3& query,
                                     const FootReach& reach, FootList& feet) noexcept;

/// All queries within some distance of one.
struct QueryBall {
    Vector3 center = Vector3::Zero();  ///< world [m]
    double radius = -1.0;              ///< < 0: no query [m]
};

/// What is proven for all queries in a ball: one of them that has a foot in `anchor` has no other
/// one within `reach` of the ball's center.
struct ProvenBall {
    QueryBall queries;
    double reach = 0.0;  ///< [m]
    Box anchor;          ///< world [m]

    /// Whether it says all about a query whose nearest foot known is this.
    [[nodiscard]] bool settles(const Vector3& query, const FootReach& within,
                               const SurfaceFoot& nearest) const noexcept;
};

/// The same for the query at the center of `queries`; @return in `ball` what is proven on the way
/// for all of them. That is nothing where other feet are near.
[[nodiscard]] FootProof completeFeet(const BSplineSurface& surface, const QueryBall& queries,
                                     const FootReach& reach, FootList& feet,
                                     ProvenBall& ball) noexcept;

}  // namespace asperity
