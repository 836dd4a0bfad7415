#include "core/surface/closest/ClosestPointTracker.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/ExhaustiveSearch.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/NearestSample.h"
#include "core/surface/closest/PartSearch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace asperity {

struct ClosestPointTracker::Proofs {
    ProvenBall ball;
    int rest = 0;  ///< queries, the last time that no ball was proven
    int untilNextTry = 0;
};

namespace {

/// Radius of the balls that are tried: smaller ones are left sooner, larger ones leave more cells
/// open [pixel].
constexpr double kBall = 0.2;
/// Queries after which another ball is tried where none was proven. A try costs about as much as it
/// spares each of the queries after it.
constexpr int kMaxRest = 31;

/// Whether the scan as a whole leaves no place for a closest point but the one that is known: all
/// of it lies so far below the query that nothing is within reach, or the distance bends up
/// everywhere.
bool isProvenByScan(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach) {
    constexpr double kSurely = 1.0 - 1e-6;
    const BoxBounds scan = surface.bounds().all();
    const double above = query.z() - scan.highest;
    return above > reach.farthest ||
           (above >= 0.0 && scan.concavity * (query.z() - scan.lowest) < kSurely);
}

/// Whether a search from `place` would most likely end at one of the closest points.
bool isBesideOneOf(const ClosestPointList& points, const Vector2& place,
                   const BSplineSurface& surface) {
    constexpr double kBeside = 1.0;  // pixel
    const BSplineSurface::Grid& grid = surface.grid();
    return std::ranges::any_of(points.all(), [&](const ClosestPoint& closest) {
        return std::abs(closest.point.x() - place.x()) <= kBeside * grid.pitchX &&
               std::abs(closest.point.y() - place.y()) <= kBeside * grid.pitchY;
    });
}

/// Adds the closest point that the nearest sample leads to.
void addLikelyPoint(const BSplineSurface& surface, const Vector3& query, const SearchReach& reach,
                    ClosestPointList& points) {
    const double limit = reach.limit(points.all().front());
    const auto place = nearestSample(surface, query, limit);
    if (!place || isBesideOneOf(points, *place, surface)) {
        return;
    }
    const ClosestPoint closest = localClosestPoint(surface, query, {place->x(), place->y(), true});
    if (closest.converged && std::abs(closest.distance) <= limit) {
        points.add(closest, sameMinimum(surface));
    }
}

}  // namespace

ClosestPointTracker::ClosestPointTracker() noexcept {
    static_assert(sizeof(Proofs) <= kProofsSize && alignof(Proofs) <= kProofsAlignment);
    new (proofs_.data()) Proofs;
}

ClosestPointTracker::ClosestPointTracker(const ClosestPointTracker& other) noexcept {
    new (proofs_.data()) Proofs(other.proofs());
}

ClosestPointTracker& ClosestPointTracker::operator=(const ClosestPointTracker& other) noexcept {
    proofs() = other.proofs();
    return *this;
}

ClosestPointTracker::~ClosestPointTracker() { std::destroy_at(&proofs()); }

ClosestPointTracker::Proofs& ClosestPointTracker::proofs() noexcept {
    return *std::launder(reinterpret_cast<Proofs*>(proofs_.data()));
}

const ClosestPointTracker::Proofs& ClosestPointTracker::proofs() const noexcept {
    return *std::launder(reinterpret_cast<const Proofs*>(proofs_.data()));
}

SearchProof ClosestPointTracker::completePoints(const BSplineSurface& surface, const Vector3& query,
                                                const SearchReach& reach, SearchEffort effort,
                                                ClosestPointList& points) noexcept {
    if (settles(surface, query, reach, effort, points.all().front())) {
        return SearchProof::Nearest;
    }
    switch (effort) {
    case SearchEffort::Local:
        return SearchProof::NotSought;
    case SearchEffort::Global:
        addLikelyPoint(surface, query, reach, points);
        return SearchProof::Likely;
    case SearchEffort::Certified:
        return provePoints(surface, query, reach, points);
    }
    return SearchProof::NotSought;
}

bool ClosestPointTracker::settles(const BSplineSurface& surface, const Vector3& query,
                                  const SearchReach& reach, SearchEffort effort,
                                  const ClosestPoint& nearest) const noexcept {
    const ProvenBall& ball = proofs().ball;
    const bool byBall = effort == SearchEffort::Certified && ball.open.empty() &&
                        ball.covers(query, reach, nearest);
    return byBall || (nearest.converged && isProvenByScan(surface, query, reach));
}

SearchProof ClosestPointTracker::provePoints(const BSplineSurface& surface, const Vector3& query,
                                             const SearchReach& reach,
                                             ClosestPointList& points) noexcept {
    auto& [ball, rest, untilNextTry] = proofs();
    SearchProof proof = SearchProof::NotSought;
    if (ball.covers(query, reach, points.all().front())) {
        proof = asperity::completePoints(surface, query, reach, ball, points);
    } else if (untilNextTry > 0) {
        --untilNextTry;
        return asperity::completePoints(surface, query, reach, points);
    } else {
        const double radius = kBall * std::min(surface.grid().pitchX, surface.grid().pitchY);
        proof = asperity::completePoints(surface, {query, radius}, reach, points, ball);
    }
    rest = ball.queries.radius > 0.0 ? 0 : std::min(2 * rest + 1, kMaxRest);
    untilNextTry = rest;
    return proof;
}

}  // namespace asperity
