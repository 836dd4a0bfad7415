#pragma once

#include "core/Vector.h"
#include "ui/view/ViewFrame.h"

#include <vector>

class vtkPolyData;

namespace asperity {

/// Directions along which a view shows the world, as drawn, unit.
struct SeenAxes {
    Vector3 right = Vector3::UnitX();
    Vector3 up = Vector3::UnitZ();
};

/// Outline of a convex body as a view without perspective shows it, closed. World frame [m].
struct SeenOutline {
    std::vector<Vector3> corners;
    Vector3 rightEnd = Vector3::Zero();
};

/// Returns the outline of a body that has points, world frame. It begins at the left end, goes
/// below to the right one, and back above. Andrew (1979), Another efficient algorithm for convex
/// hulls in two dimensions.
[[nodiscard]] SeenOutline seenOutline(vtkPolyData* body, const SeenAxes& axes,
                                      const DrawnSpace& space);

}  // namespace asperity
