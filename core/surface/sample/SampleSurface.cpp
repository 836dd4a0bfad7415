#include "core/surface/sample/SampleSurface.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/nurbs/NurbsClosestPoint.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Hollows this much wider than a query's distance hold no second closest point.
constexpr double kShallow = 0.5;
/// A closest point that bears a force lies no farther than this, in distances of the nearest one.
constexpr double kFartherPoint = 2.0;

ClosestPoint localPointOn(const NurbsSurface& surface, const Vector3& query,
                          const SearchGuess& guess) noexcept {
    ClosestPoint nearest = closestPoint(surface, query, guess);
    if (!guess.valid || surface.concavity() * std::abs(nearest.distance) < kShallow) {
        return nearest;
    }
    const NurbsClosestPoints points =
        nearestPoints(surface, query,
                      {.within = kFartherPoint * std::abs(nearest.distance),
                       .sameWithin = kSamePoint * std::abs(nearest.distance)});
    const auto away = [&](const NurbsClosestPoint& closest) {
        return std::hypot(closest.closest.point.x() - guess.x, closest.closest.point.y() - guess.y);
    };
    return std::min_element(points.all().begin(), points.all().end(),
                            [&](const NurbsClosestPoint& a, const NurbsClosestPoint& b) {
                                return away(a) < away(b);
                            })
        ->closest;
}

ContactPoints tipPointsOn(const NurbsSurface& surface, const TipSphere& tip,
                          double reach) noexcept {
    const double within = tip.radius + reach;
    // A valley that is wider than the tip holds it at one position.
    const bool several = surface.concavity() * within > 1.0;
    const double same = kSamePoint * tip.radius;
    const NurbsClosestPoints found =
        nearestPoints(surface, tip.center, {.within = several ? within : 0.0, .sameWithin = same});
    ContactPoints points;
    for (const NurbsClosestPoint& closest : found.all()) {
        points.list.add(closest.closest, same);
    }
    const bool isFar = found.nearest().closest.distance > within;
    points.proof =
        found.proof() == SearchProof::Nearest && isFar ? SearchProof::OutOfReach : found.proof();
    return points;
}

/// Returns whether a tip's center lies below a height field.
bool isSubmerged(const BSplineSurface& surface, const Vector3& center) noexcept {
    return surface.contains(center.x(), center.y()) &&
           center.z() < surface.at(center.x(), center.y()).height;
}

/// Returns where the tip's axis leaves the sample, above a submerged center.
ClosestPoint pointOnAxis(const BSplineSurface& surface, const Vector3& center) noexcept {
    const HeightSample sample = surface.at(center.x(), center.y());
    ClosestPoint above;
    above.point = Vector3(center.x(), center.y(), sample.height);
    above.normal = sample.normal();
    above.distance = (center.z() - sample.height) * above.normal.z();
    above.curvatures = principalCurvatures(sample);
    above.converged = true;
    above.proof = SearchProof::Nearest;
    return above;
}

}  // namespace

ContactPoints SampleSurface::contactPoints(const TipSphere& tip, double reach,
                                           std::span<const SearchGuess> known,
                                           ClosestPointTracker& tracker) const noexcept {
    if (const auto* const* field = std::get_if<const BSplineSurface*>(&surface_)) {
        if (isSubmerged(**field, tip.center)) {
            ContactPoints points;
            points.list.add(pointOnAxis(**field, tip.center), 0.0);
            points.proof = SearchProof::Nearest;
            return points;
        }
        return asperity::contactPoints(**field, tip, {reach, effort_}, known, tracker);
    }
    return tipPointsOn(*std::get<const NurbsSurface*>(surface_), tip, reach);
}

ClosestPoint SampleSurface::localContactPoint(const Vector3& center,
                                              const SearchGuess& guess) const noexcept {
    if (const auto* const* field = std::get_if<const BSplineSurface*>(&surface_)) {
        return isSubmerged(**field, center) ? pointOnAxis(**field, center)
                                            : asperity::localClosestPoint(**field, center, guess);
    }
    return localPointOn(*std::get<const NurbsSurface*>(surface_), center, guess);
}

}  // namespace asperity
