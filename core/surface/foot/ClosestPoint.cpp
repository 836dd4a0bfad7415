#include "core/surface/foot/ClosestPoint.h"

#include "core/surface/foot/FootSearch.h"
#include "core/surface/foot/LocalFoot.h"

namespace asperity {

SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                         const FootGuess& guess) noexcept {
    const SurfaceFoot start = localFoot(surface, query, guess);
    if (!isUsableQuery(query)) {
        return start;
    }
    FootList feet;
    feet.add(start, 0.0);
    const FootProof proof = completeFeet(surface, query, {}, feet);
    SurfaceFoot foot = feet.all().front();
    foot.proof = foot.converged ? proof : FootProof::NotConverged;
    return foot;
}

}  // namespace asperity
