#pragma once

#include "core/Vector.h"
#include "core/surface/closest/Box.h"
#include "core/surface/closest/KnownParts.h"
#include "core/surface/closest/SearchReach.h"

namespace asperity {

class BSplineSurface;
class ClosestPointList;

/// Looks everywhere for closest points of `query`: local minima of its distance from the surface
/// within `reach`, and adds them to `points`, which holds at least one local closest point already.
///
/// Cells that lie too far, or around a known closest point where the distance can only grow, are
/// ruled out by their bounds; the others are quartered until the distance has no minimum in them,
/// or one that is found. @return Nearest: the list is complete, as far as it has room;
/// TooManyPoints: it need not be. Allocation-free, bounded, never throws.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                         const SearchReach& reach,
                                         ClosestPointList& points) noexcept;

/// All queries within some distance of one.
struct QueryBall {
    Vector3 center = Vector3::Zero();  ///< world [m]
    double radius = -1.0;              ///< < 0: no query [m]
};

/// What is proven for all queries in a ball: one of them that has a closest point in `anchor` has
/// no other one within `reach` of the ball's center, but in the parts of cells that are left open.
struct ProvenBall {
    QueryBall queries;
    double reach = 0.0;  ///< [m]
    Box anchor;          ///< world [m]
    KnownParts open;

    /// Whether it speaks of a query whose nearest closest point known is this.
    [[nodiscard]] bool covers(const Vector3& query, const SearchReach& within,
                              const ClosestPoint& nearest) const noexcept;
};

/// The same for a query that a ball covers; what it finds out about the open parts is kept there.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const Vector3& query,
                                         const SearchReach& reach, ProvenBall& ball,
                                         ClosestPointList& points) noexcept;

/// The same for the query at the center of `queries`; @return in `ball` what is proven on the way
/// for all of them, with what is known already of its open parts. That is nothing where too many
/// are left open.
[[nodiscard]] SearchProof completePoints(const BSplineSurface& surface, const QueryBall& queries,
                                         const SearchReach& reach, ClosestPointList& points,
                                         ProvenBall& ball) noexcept;

}  // namespace asperity
