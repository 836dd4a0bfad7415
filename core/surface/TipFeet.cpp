#include "core/surface/TipFeet.h"

#include "core/surface/FootSearch.h"
#include "core/surface/LocalFoot.h"

namespace asperity {

namespace {

/// A foot that lies farther than the nearest one by more than this bears too little of the force to
/// matter: across a gap of 3 nm van der Waals attraction is a hundredth of that in contact [m].
constexpr double kBehindNearest = 3e-9;

/// Minima this near to each other bear one contact, which must not be counted twice.
FootList withoutDoubles(const FootList& feet, double same) {
    FootList apart;
    for (const SurfaceFoot& foot : feet.all()) {
        apart.add(foot, same);
    }
    return apart;
}

}  // namespace

TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                std::span<const FootGuess> known) noexcept {
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
    feet.proof = completeFeet(surface, tip.centre,
                              {.farthest = within, .behindNearest = kBehindNearest}, feet.list);
    if (feet.list.hasLeftOut()) {
        feet.proof = FootProof::ManyFeet;
    }
    feet.list = withoutDoubles(feet.list, same);
    if (feet.list.all().front().distance > within && feet.proof == FootProof::Nearest) {
        feet.proof = FootProof::OutOfReach;
    }
    return feet;
}

}  // namespace asperity
