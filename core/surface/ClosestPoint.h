#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"

namespace asperity {

/// Where a search starts; kept from one query to the next.
struct FootGuess {
    double x = 0.0;  ///< world [m]
    double y = 0.0;  ///< world [m]
    bool valid = false;
};

/// Foot of a point on the surface: the surface point nearest to it.
struct SurfaceFoot {
    Vector3 point = Vector3::Zero();    ///< on the surface, world [m]
    Vector3 normal = Vector3::UnitZ();  ///< unit, out of the sample
    double distance = 0.0;              ///< signed, < 0 below the surface [m]
    int iterations = 0;                 ///< Newton steps spent, over all starts
    bool converged = false;             ///< the gradient condition holds to rounding
    bool certified = false;             ///< proven that no other surface point is nearer
    bool insideScan = true;             ///< the foot lies within the scan
};

/// Foot of `query` by Newton-Raphson on r.Su = 0, r.Sv = 0, started from `guess` when valid, then
/// from the projection along z, then from points nearby. Allocation-free, bounded, never throws.
/// Source: Vogl, Ma, Sitti (2005), section III.
[[nodiscard]] SurfaceFoot closestPoint(const BSplineSurface& surface, const Vector3& query,
                                       const FootGuess& guess) noexcept;

}  // namespace asperity
