#include "core/surface/closest/ContactPoints.h"

#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// The closest point, and those of the others that lie within `farthest` [m]. Minima nearer to each
/// other than `same` [m] bear one contact, which must not be counted twice.
ClosestPointList bearing(const ClosestPointList& points, double same, double farthest) {
    ClosestPointList apart;
    apart.add(points.all().front(), same);
    for (const ClosestPoint& closest : points.all().subspan(1)) {
        if (std::abs(closest.distance) <= farthest) {
            apart.add(closest, same);
        }
    }
    return apart;
}

/// Pixels within which a spline has no two bumps.
constexpr double kOneBump = 0.5;

/// Returns whether a closest point is left out of the list that a tip may touch beside those in it.
/// @param bump width of one [m]
bool joinsBumps(const ClosestPointList& minima, const ClosestPointList& apart, double bump,
                double farthest) {
    return std::ranges::any_of(minima.all(), [&](const ClosestPoint& closest) {
        const auto isNear = [&](const ClosestPoint& other) {
            return (other.point - closest.point).norm() <= bump;
        };
        return std::abs(closest.distance) <= farthest && std::ranges::none_of(apart.all(), isNear);
    });
}

/// Which closest points a tip may press on or be attracted by: all that lie in its sphere or within
/// `reach` of it, however much nearer another one is. Below the surface there is no out of reach:
/// however deep the center lies, the nearest way out is what pushes it.
SearchReach reachOf(const BSplineSurface& surface, const TipSphere& tip, double reach) {
    const Vector3& center = tip.center;
    const bool isBelow = center.z() < surface.at(center.x(), center.y()).height;
    return {.farthest = isBelow ? std::numeric_limits<double>::infinity() : tip.radius + reach,
            .behindNearest = reach,
            .radius = tip.radius};
}

/// @param complete completes the minima of the distance from the tip's center
template <class Complete>
ContactPoints pointsOf(const BSplineSurface& surface, const TipSphere& tip, double reach,
                       std::span<const SearchGuess> known, const Complete& complete) {
    ContactPoints points;
    const double same = kSamePoint * tip.radius;
    for (const SearchGuess& guess : known) {
        points.list.add(localClosestPoint(surface, tip.center, guess), same);
    }
    if (known.empty()) {
        points.list.add(localClosestPoint(surface, tip.center, {}), same);
    }
    if (!isUsableQuery(tip.center)) {
        points.proof = SearchProof::NotConverged;
        return points;
    }
    const SearchReach within = reachOf(surface, tip, reach);
    ClosestPointList minima = points.list;
    points.proof = complete(within, minima);
    const double nearest = std::abs(minima.all().front().distance);
    const double farthest = within.limit(nearest);
    points.list = bearing(minima, same, farthest);
    const double bump = kOneBump * std::min(surface.grid().pitchX, surface.grid().pitchY);
    points.joined = same > bump && joinsBumps(minima, points.list, bump, farthest);
    if (minima.hasLeftOut(farthest)) {
        points.proof = SearchProof::TooManyPoints;
    }
    if (nearest > within.farthest && points.proof == SearchProof::Nearest) {
        points.proof = SearchProof::OutOfReach;
    }
    return points;
}

}  // namespace

ContactPoints contactPoints(const BSplineSurface& surface, const TipSphere& tip, double reach,
                            std::span<const SearchGuess> known) noexcept {
    return pointsOf(surface, tip, reach, known,
                    [&](const SearchReach& within, ClosestPointList& minima) {
                        return completePoints(surface, tip.center, within, minima);
                    });
}

ContactPoints contactPoints(const BSplineSurface& surface, const TipSphere& tip,
                            const ContactPointSearch& sought, std::span<const SearchGuess> known,
                            ClosestPointTracker& tracker) noexcept {
    return pointsOf(
        surface, tip, sought.reach, known, [&](const SearchReach& reach, ClosestPointList& minima) {
            return tracker.completePoints(surface, tip.center, reach, sought.effort, minima);
        });
}

}  // namespace asperity
