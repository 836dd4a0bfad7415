#include "core/surface/closest/ClosestPointSearch.h"

#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"

namespace asperity {

namespace {

/// @param complete completes the closest points of the query
template <class Complete>
ClosestPoint nearestPoint(const BSplineSurface& surface, const Vector3& query,
                          const SearchGuess& guess, const Complete& complete) {
    ClosestPoint start = localClosestPoint(surface, query, guess);
    if (!isUsableQuery(query)) {
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
    return nearestPoint(surface, query, guess, [&](ClosestPointList& points) {
        return completePoints(surface, query, {}, points);
    });
}

ClosestPoint closestPoint(const BSplineSurface& surface, const Vector3& query,
                          const SearchGuess& guess, ClosestPointTracker& tracker,
                          SearchEffort effort) noexcept {
    return nearestPoint(surface, query, guess, [&](ClosestPointList& points) {
        return tracker.completePoints(surface, query, {}, effort, points);
    });
}

}  // namespace asperity
