#include "core/surface/foot/TipFeet.h"

#include "core/surface/foot/FootSearch.h"
#include "core/surface/foot/LocalFoot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// A foot that lies farther than the nearest one by more than this bears too little of the force to
/// matter: across a gap of 3 nm van der Waals attraction is a hundredth of that in contact [m].
constexpr double kBehindNearest = 3e-9;

/// The nearest foot, and those of the others that lie within `farthest` [m]. Minima nearer to each
/// other than `same` [m] bear one contact, which must not be counted twice.
FootList bearing(const FootList& feet, double same, double farthest) {
    FootList apart;
    apart.add(feet.all().front(), same);
    for (const SurfaceFoot& foot : feet.all().subspan(1)) {
        if (std::abs(foot.distance) <= farthest) {
            apart.add(foot, same);
        }
    }
    return apart;
}

/// How far from its center a tip is to have feet [m]. Below the surface there is no out of reach:
/// however deep the center lies, the nearest way out is what pushes it.
double farthestFoot(const BSplineSurface& surface, const TipSphere& tip, double reach) {
    const Vector3& center = tip.center;
    return center.z() < surface.at(center.x(), center.y()).height
               ? std::numeric_limits<double>::infinity()
               : tip.radius + reach;
}

/// @param complete completes the minima of the distance from the tip's center
template <class Complete>
TipFeet feetOf(const BSplineSurface& surface, const TipSphere& tip, double reach,
               std::span<const FootGuess> known, const Complete& complete) {
    TipFeet feet;
    const double same = kSameFoot * tip.radius;
    for (const FootGuess& guess : known) {
        feet.list.add(localFoot(surface, tip.center, guess), same);
    }
    if (known.empty()) {
        feet.list.add(localFoot(surface, tip.center, {}), same);
    }
    if (!isUsableQuery(tip.center)) {
        feet.proof = FootProof::NotConverged;
        return feet;
    }
    const double within = farthestFoot(surface, tip, reach);
    FootList minima = feet.list;
    feet.proof = complete({.farthest = within, .behindNearest = kBehindNearest}, minima);
    const double nearest = std::abs(minima.all().front().distance);
    feet.list = bearing(minima, same, std::min(within, nearest + kBehindNearest));
    if (minima.hasLeftOut() || feet.list.all().size() > kMaxFeet) {
        feet.proof = FootProof::ManyFeet;
        feet.list.keepNearest(kMaxFeet);
    }
    if (nearest > within && feet.proof == FootProof::Nearest) {
        feet.proof = FootProof::OutOfReach;
    }
    return feet;
}

}  // namespace

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                std::span<const FootGuess> known) noexcept {
    return feetOf(surface, tip, reach, known, [&](const FootReach& within, FootList& minima) {
        return completeFeet(surface, tip.center, within, minima);
    });
}

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, const FeetSought& sought,
                std::span<const FootGuess> known, FootTracker& tracker) noexcept {
    return feetOf(surface, tip, sought.reach, known, [&](const FootReach& reach, FootList& minima) {
        return tracker.completeFeet(surface, tip.center, reach, sought.effort, minima);
    });
}

}  // namespace asperity
