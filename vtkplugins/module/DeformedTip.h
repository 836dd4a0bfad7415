#pragma once

#include "core/Vector.h"
#include "core/surface/deformation/SurfaceDeformation.h"

class vtkPolyData;

namespace asperity {

/// Moves the points of a tip by its own share of the displacement, into the tip; world frame,
/// meters.
/// @param center of the tip's sphere [m] @param outward axis of the contact, unit, out of the
/// sample
/// @param displacement over the distance from the axis; empty: the tip is rigid
void deformTip(vtkPolyData& tip, const Vector3& center, const Vector3& outward,
               const RadialDisplacement& displacement);

}  // namespace asperity
