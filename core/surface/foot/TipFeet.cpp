#include "core/surface/foot/TipFeet.h"

#include "core/surface/foot/FootSearch.h"
#include "core/surface/foot/LocalFoot.h"

#include <algorithm>
#include <cmath>

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

/// @param complete completes the minima of the distance from the tip's centre
template <class Complete>
TipFeet feetOf(const BSplineSurface& surface, const TipSphere& tip, double reach,
               std::span<const FootGuess> known, const Complete& complete) {
    TipFeet feet;
    const double same = kSameFoot * tip.radius;
    for (const FootGuess& guess : known) {
        feet.list.add(localFoot(surface, tip.centre, guess), same);
    }
    if (known.empty()) {
        feet.list.add(localFoot(surface, tip.centre, {}), same);
    }
    if (!isUsableQuery(tip.centre)) {
        feet.proof = FootProof::NotConverged;
        return feet;
    }
    const double within = tip.radius + reach;
    FootList minima = feet.list;
    feet.proof = complete({.farthest = within, .behindNearest = kBehindNearest}, minima);
    const double nearest = std::abs(minima.all().front().distance);
    feet.list = bearing(minima, same, std::min(within, nearest + kBehindNearest));
    if (minima.hasLeftOut() || feet.list.all().size() > kMostFeet) {
        feet.proof = FootProof::ManyFeet;
        feet.list.keepNearest(kMostFeet);
    }
    if (feet.list.all().front().distance > within && feet.proof == FootProof::Nearest) {
        feet.proof = FootProof::OutOfReach;
    }
    return feet;
}

}  // namespace

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                std::span<const FootGuess> known) noexcept {
    return feetOf(surface, tip, reach, known, [&](const FootReach& within, FootList& minima) {
        return completeFeet(surface, tip.centre, within, minima);
    });
}

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                std::span<const FootGuess> known, FootTracker& tracker) noexcept {
    return feetOf(surface, tip, reach, known, [&](const FootReach& within, FootList& minima) {
        return tracker.completeFeet(surface, tip.centre, within, minima);
    });
}

}  // namespace asperity
