#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"

namespace asperity {

/// When Newton's method ends: at the first step shorter than this, which is still taken.
struct NewtonEnd {
    double step = 0.0;  ///< [m]
};

/// A local minimum of the distance from `query`, by Newton's method downhill from `start` (world
/// x, y), inside the scan. On its own, not the product's: it is part of what the product is
/// compared with.
[[nodiscard]] Vector2 newtonPoint(const BSplineSurface& surface, const Vector3& query,
                                  const Vector2& start, NewtonEnd end);

/// Distance from `query` to the surface point above or below `position` [m], > 0.
[[nodiscard]] double distanceTo(const BSplineSurface& surface, const Vector3& query,
                                const Vector2& position);

}  // namespace asperity
