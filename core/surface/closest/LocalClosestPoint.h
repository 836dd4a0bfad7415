#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/closest/ClosestPoint.h"

namespace asperity {

/// Half the squared distance from the query to the surface point above or below a position [m^2].
class HalfSquaredDistance {
public:
    HalfSquaredDistance(const BSplineSurface& surface, const Vector3& query) noexcept
        : surface_(surface), query_(query), rounding_(roundingOf(surface, query)) {}

    [[nodiscard]] LocalModel operator()(const Vector2& position) const noexcept;

private:
    const BSplineSurface& surface_;
    Vector3 query_;
    SurfaceRounding rounding_;
};

/// Returns whether distances can be computed from a query.
[[nodiscard]] bool isUsableQuery(const Vector3& query) noexcept;

/// The closest point at a minimum of the distance; its proof is still to be sought.
[[nodiscard]] ClosestPoint closestPointOf(const BoxMinimum& minimum, const Vector3& query) noexcept;

/// Newton's method from a start close to a minimum, without the care that BoxNewton takes: whether
/// it soon ended at one.
/// @param minimum at first the start, then position, surface and steps of the minimum
[[nodiscard]] bool findMinimumBeside(const BSplineSurface& surface, const Vector3& query,
                                     BoxMinimum& minimum) noexcept;

/// A local minimum of the distance from `query`, by Newton-Raphson on r.Su = 0, r.Sv = 0 downhill
/// from `guess` when valid, else (or when that ends nowhere) from the projection along z, then from
/// points nearby. Allocation-free, bounded, never throws.
/// Source: Vogl, Ma, Sitti (2005), section III.
[[nodiscard]] ClosestPoint localClosestPoint(const BSplineSurface& surface, const Vector3& query,
                                             const SearchGuess& guess) noexcept;

}  // namespace asperity
