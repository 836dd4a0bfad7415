#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"

#include <optional>

namespace asperity {

/// A straight line of sight, from the eye on; world frame.
struct SurfaceRay {
    Vector3 origin = Vector3::Zero();       ///< [m]
    Vector3 direction = -Vector3::UnitZ();  ///< of any length but 0
};

/// The first place of the surface that a line of sight meets within a rectangle of the scan, from
/// above; found to 1e-13 of the surface's extent. The ray is followed in steps of half a pixel:
/// a ridge that it touches over less than that may be missed. None where the ray does not meet the
/// surface there, or is below it where it comes into the rectangle: it sees the cut face.
/// @param low, high corners of the rectangle, world x, y [m]
[[nodiscard]] std::optional<Vector3> firstHit(const BSplineSurface& surface, const SurfaceRay& ray,
                                              const Vector2& low, const Vector2& high);

}  // namespace asperity
