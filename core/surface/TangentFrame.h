#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"

#include <vector>

namespace asperity {

/// The plane that touches a surface at one point; right-handed, axes of unit length, world frame.
struct TangentFrame {
    Vector3 origin = Vector3::Zero();   ///< on the surface [m]
    Vector3 along = Vector3::UnitX();   ///< in the plane, as near to world x as it can be
    Vector3 across = Vector3::UnitY();  ///< in the plane
    Vector3 normal = Vector3::UnitZ();  ///< out of the sample

    /// A world point by its positions along the three axes [m].
    [[nodiscard]] Vector3 local(const Vector3& world) const;
};

/// @param normal of unit length
[[nodiscard]] TangentFrame tangentFrame(const Vector3& origin, const Vector3& normal);

/// Heights of the surface over its tangent plane, along the normal, at the middles of
/// samples x samples squares around the origin, row-major, rows along `across` [m].
/// -infinity where the surface is not met: an overhang as seen along the normal.
[[nodiscard]] std::vector<double> heightsOver(const BSplineSurface& surface,
                                              const TangentFrame& frame, int samples, double pitch);

}  // namespace asperity
