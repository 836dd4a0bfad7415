#pragma once

#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/nurbs/NurbsSurface.h"

#include <array>
#include <span>

namespace asperity {

/// Beyond this no square can be compared with another one. [m]
inline constexpr double kMaxQueryDistance = 1e50;

/// A closest point and where it lies on the surface.
struct NurbsClosestPoint {
    ClosestPoint closest;  ///< `insideScan`: not held back by an edge of the surface
    double u = 0.0;
    double v = 0.0;
};

/// The closest point and on request others, nearest first. The proof is about the nearest one:
/// TooManyPoints also where the query is its center of curvature, so that it may be one of many, or
/// where the search for the others was cut short or found more than have room.
class NurbsClosestPoints {
public:
    [[nodiscard]] std::span<const NurbsClosestPoint> all() const noexcept {
        return {points_.data(), count_};
    }
    [[nodiscard]] const NurbsClosestPoint& nearest() const noexcept { return points_.front(); }
    [[nodiscard]] SearchProof proof() const noexcept { return proof_; }
    /// Pieces of the surface looked at one by one.
    [[nodiscard]] int pieces() const noexcept { return pieces_; }

private:
    friend class NurbsClosestPointSearch;

    std::array<NurbsClosestPoint, kMaxContactPoints> points_{};
    std::size_t count_ = 0;
    SearchProof proof_ = SearchProof::NotSought;
    int pieces_ = 0;
};

/// Closest points that are wanted beside the nearest one.
struct NurbsClosestPointWish {
    double within = 0.0;       ///< those at most so far away; 0: none [m]
    double sameWithin = 1e-9;  ///< closest points nearer to each other than this are one [m]
};

/// The surface point nearest to the query, and on request the other local minima of the distance.
/// Global: every part of the surface is looked at or ruled out, by bounds on the squared distance
/// over rational Bezier patches, cut until it is convex or above the best closest point. The
/// closest point is proven to about 1e-13 of the larger of surface and query; of the others some
/// may be missing. Allocation-free, bounded, never throws. Source: Johnson, Cohen (1998) for the
/// branch and bound; Vogl, Ma, Sitti (2005), section III, for r.Su = 0, r.Sv = 0.
[[nodiscard]] NurbsClosestPoints nearestPoints(const NurbsSurface& surface, const Vector3& query,
                                               const NurbsClosestPointWish& wish) noexcept;

/// The closest point alone. No guess is needed.
[[nodiscard]] ClosestPoint closestPoint(const NurbsSurface& surface, const Vector3& query,
                                        const SearchGuess& guess) noexcept;

}  // namespace asperity
