#include "tests/core/probe/PlanarForce.h"

#include "core/probe/Sliding.h"

#include <cmath>

namespace asperity {

PlanarForce planarForce(const Cantilever& cantilever, const LeverSignals& signals,
                        const Vector3& normal, const Vector3& velocity) noexcept {
    constexpr double kSmallestDeterminant = 1e-12;
    const Vector3 n = cantilever.rotation() * normal;
    const Sliding sliding = slidingOf(n, cantilever.rotation() * velocity);
    const Vector3 p = n.cross(sliding.friction);
    const double kappa = cantilever.couplingRatio();
    PlanarForce result;
    if (sliding.certainty == 0.0) {
        return result;
    }
    result.determinant = p.x() - (kappa * p.z());
    result.singular = std::abs(result.determinant) < kSmallestDeterminant;
    if (!result.singular) {
        const double y1 = signals.bending / cantilever.bendingPerFz();
        const double y2 = signals.torsion / cantilever.torsionPerFy();
        const Vector3 scaled(-(p.y() * y2) - (p.z() * y1), result.determinant * y2,
                             (p.x() * y1) + (kappa * p.y() * y2));
        result.force = cantilever.rotation().transpose() * scaled / result.determinant;
    }
    return result;
}

}  // namespace asperity
