#include "core/surface/touched/TouchedSurface.h"

#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/LocalFoot.h"
#include "core/surface/foot/TipFeet.h"
#include "core/surface/nurbs/NurbsFoot.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Hollows this much wider than a query's distance hold no second foot.
constexpr double kShallow = 0.5;
/// A foot that bears a force lies no farther than this, in distances of the nearest one.
constexpr double kFartherFoot = 2.0;

SurfaceFoot localFootOn(const NurbsSurface& surface, const Vector3& query,
                        const FootGuess& guess) noexcept {
    SurfaceFoot nearest = closestPoint(surface, query, guess);
    if (!guess.valid || surface.concavity() * std::abs(nearest.distance) < kShallow) {
        return nearest;
    }
    const NurbsFeet feet =
        nearestFeet(surface, query, {.within = kFartherFoot * std::abs(nearest.distance)});
    const auto away = [&](const NurbsFoot& foot) {
        return std::hypot(foot.foot.point.x() - guess.x, foot.foot.point.y() - guess.y);
    };
    return std::min_element(
               feet.all().begin(), feet.all().end(),
               [&](const NurbsFoot& a, const NurbsFoot& b) { return away(a) < away(b); })
        ->foot;
}

TipFeet tipFeetOn(const NurbsSurface& surface, const TipSphere& tip, double reach) noexcept {
    const double within = tip.radius + reach;
    // A valley that is wider than the tip holds it at one place.
    const bool several = surface.concavity() * within > 1.0;
    const double same = kSameFoot * tip.radius;
    const NurbsFeet found =
        nearestFeet(surface, tip.center, {.within = several ? within : 0.0, .sameWithin = same});
    TipFeet feet;
    for (const NurbsFoot& foot : found.all()) {
        feet.list.add(foot.foot, same);
    }
    const bool isFar = found.nearest().foot.distance > within;
    feet.proof =
        found.proof() == FootProof::Nearest && isFar ? FootProof::OutOfReach : found.proof();
    return feet;
}

}  // namespace

TipFeet TouchedSurface::tipFeet(const TipSphere& tip, double reach,
                                std::span<const FootGuess> known,
                                FootTracker& tracker) const noexcept {
    if (const auto* const* field = std::get_if<const BSplineSurface*>(&surface_)) {
        return asperity::tipFeet(**field, tip, {reach, effort_}, known, tracker);
    }
    return tipFeetOn(*std::get<const NurbsSurface*>(surface_), tip, reach);
}

SurfaceFoot TouchedSurface::localFoot(const Vector3& query, const FootGuess& guess) const noexcept {
    if (const auto* const* field = std::get_if<const BSplineSurface*>(&surface_)) {
        return asperity::localFoot(**field, query, guess);
    }
    return localFootOn(*std::get<const NurbsSurface*>(surface_), query, guess);
}

}  // namespace asperity
