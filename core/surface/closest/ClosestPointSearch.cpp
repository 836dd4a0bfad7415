#include "core/surface/closest/ClosestPointSearch.h"

#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"

namespace asperity {

namespace {

/// @param settles whether a closest point is known to be the nearest
/// @param complete completes the closest points of the query
template <class Settles, class Complete>
ClosestPoint nearestPoint(const BSplineSurface& surface, const Vector3& query,
                          const SearchGuess& guess, const Settles& settles,
                          const Complete& complete) {
    ClosestPoint start = localClosestPoint(surface, query, guess);
    if (!isUsableQuery(query)) {
        return start;
    }
    if (settles(start)) {
        start.proof = SearchProof::Nearest;
        return start;
    }
    ClosestPointList points;
    points.add(start, 0.0);
    const SearchProof proof = complete(points);
    ClosestPoint closest = points.all().front();
    closest.proof = closest.converged ? proof : SearchProof::NotConverged;
    return closest;
}

}  // namespace

ClosestPoint closestPoint(const BSplineSurface& surface, const Vector3& query,
                          const SearchGuess& guess) noexcept {
    return nearestPoint(
        surface, query, guess, [](const ClosestPoint&) { return false; },
        [&](ClosestPointList& points) { return completePoints(surface, query, {}, points); });
}

ClosestPoint closestPoint(const BSplineSurface& surface, const Vector3& query,
                          const SearchGuess& guess, ClosestPointTracker& tracker,
                          SearchEffort effort) noexcept {
    return nearestPoint(
        surface, query, guess,
        [&](const ClosestPoint& nearest) {
            return tracker.settles(surface, query, {}, effort, nearest);
        },
        [&](ClosestPointList& points) {
            return tracker.completePoints(surface, query, {}, effort, points);
        });
}

}  // namespace asperity
