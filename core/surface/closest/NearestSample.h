#pragma once

#include "core/surface/BSplineSurface.h"

#include <optional>

namespace asperity {

/// The pixel likeliest to lead downhill to the place that comes nearest to `query`: of those whose
/// centers lie within `distance` [m] of it as seen from above, at most 15 to each side, the one
/// from which a step within the pixel would leave the least distance. A sample says nothing of what
/// lies between the pixels. In a time that grows with the pixels looked at, about a nanosecond
/// each. Allocation-free.
/// @return its center, world x, y [m]; none where no pixel lies within the distance
[[nodiscard]] std::optional<Vector2> nearestSample(const BSplineSurface& surface,
                                                   const Vector3& query, double distance) noexcept;

}  // namespace asperity
