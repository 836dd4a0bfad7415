#include "core/surface/foot/FootTracker.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/FootList.h"
#include "core/surface/foot/LocalFoot.h"
#include "core/surface/foot/NearestSample.h"
#include "core/surface/foot/PartSearch.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Radius of the balls that are tried: in larger ones a foot stands alone less often [pixel].
constexpr double kBall = 0.125;
/// Queries after which another ball is tried where none was proven. A try costs about as much as it
/// spares each of the queries after it.
constexpr int kLongestRest = 31;

/// Whether the scan as a whole leaves no place for a foot but the one that is known: all of it lies
/// so far below the query that nothing is within reach, or the distance bends up everywhere.
bool isProvenByScan(const BSplineSurface& surface, const Vector3& query, const FootReach& reach) {
    constexpr double kSurely = 1.0 - 1e-6;
    const BoxBounds scan = surface.bounds().all();
    const double above = query.z() - scan.highest;
    return above > reach.farthest ||
           (above >= 0.0 && scan.concavity * (query.z() - scan.lowest) < kSurely);
}

/// Whether a search from `place` would most likely end at one of the feet.
bool isBesideOneOf(const FootList& feet, const Vector2& place, const BSplineSurface& surface) {
    constexpr double kBeside = 1.0;  // pixel
    const BSplineSurface::Grid& grid = surface.grid();
    return std::ranges::any_of(feet.all(), [&](const SurfaceFoot& foot) {
        return std::abs(foot.point.x() - place.x()) <= kBeside * grid.pitchX &&
               std::abs(foot.point.y() - place.y()) <= kBeside * grid.pitchY;
    });
}

/// Adds the foot that the nearest sample leads to.
void addLikelyFoot(const BSplineSurface& surface, const Vector3& query, const FootReach& reach,
                   FootList& feet) {
    const double limit = reach.limit(feet.all().front());
    const auto place = nearestSample(surface, query, limit);
    if (!place || isBesideOneOf(feet, *place, surface)) {
        return;
    }
    const SurfaceFoot foot = localFoot(surface, query, {place->x(), place->y(), true});
    if (foot.converged && std::abs(foot.distance) <= limit) {
        feet.add(foot, sameMinimum(surface));
    }
}

}  // namespace

FootProof FootTracker::completeFeet(const BSplineSurface& surface, const Vector3& query,
                                    const FootReach& reach, FootEffort effort,
                                    FootList& feet) noexcept {
    if (feet.all().front().converged && isProvenByScan(surface, query, reach)) {
        return FootProof::Nearest;
    }
    switch (effort) {
    case FootEffort::Local:
        return FootProof::NotSought;
    case FootEffort::Global:
        addLikelyFoot(surface, query, reach, feet);
        return FootProof::Likely;
    case FootEffort::Certified:
        return proveFeet(surface, query, reach, feet);
    }
    return FootProof::NotSought;
}

FootProof FootTracker::proveFeet(const BSplineSurface& surface, const Vector3& query,
                                 const FootReach& reach, FootList& feet) noexcept {
    if (ball_.settles(query, reach, feet.all().front())) {
        return FootProof::Nearest;
    }
    if (untilNextTry_ > 0) {
        --untilNextTry_;
        return asperity::completeFeet(surface, query, reach, feet);
    }
    const double radius = kBall * std::min(surface.grid().pitchX, surface.grid().pitchY);
    const FootProof proof = asperity::completeFeet(surface, {query, radius}, reach, feet, ball_);
    rest_ = ball_.queries.radius > 0.0 ? 0 : std::min(2 * rest_ + 1, kLongestRest);
    untilNextTry_ = rest_;
    return proof;
}

}  // namespace asperity
