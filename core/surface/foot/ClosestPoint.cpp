#include "core/surface/foot/ClosestPoint.h"

#include "core/surface/foot/FootList.h"
#include "core/surface/foot/FootSearch.h"
#include "core/surface/foot/LocalFoot.h"

namespace asperity {

namespace {

/// @param complete completes the feet of the query
template <class Complete>
SurfaceFoot nearestFoot(const BSplineSurface& surface, const Vector3& query, const FootGuess& guess,
                        const Complete& complete) {
    SurfaceFoot start = localFoot(surface, query, guess);
    if (!isUsableQuery(query)) {
        return start;
    }
    FootList feet;
    feet.add(start, 0.0);
    const FootProof proof = complete(feet);
    SurfaceFoot foot = feet.all().front();
    foot.proof = foot.converged ? proof : FootProof::NotConverged;
    return foot;
}

}  // namespace

SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                         const FootGuess& guess) noexcept {
    return nearestFoot(surface, query, guess,
                       [&](FootList& feet) { return completeFeet(surface, query, {}, feet); });
}

SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                         const FootGuess& guess, FootTracker& tracker, FootEffort effort) noexcept {
    return nearestFoot(surface, query, guess, [&](FootList& feet) {
        return tracker.completeFeet(surface, query, {}, effort, feet);
    });
}

}  // namespace asperity
