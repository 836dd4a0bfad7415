#pragma once

#include "core/Vector.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace asperity {

/// An upright plane that opens a block to the eye: what lies in front of it is not drawn.
struct CutPlane {
    Vector3 origin = Vector3::Zero();     ///< on the plane
    Vector3 toFront = -Vector3::UnitY();  ///< level, unit, out of what is left
};

/// Returns what lies behind the plane, with its point data.
[[nodiscard]] vtkSmartPointer<vtkPolyData> behind(vtkPolyData* data, const CutPlane& plane);

/// Returns the line in which the plane meets a surface; empty where it does not.
[[nodiscard]] vtkSmartPointer<vtkPolyData> cutLine(vtkPolyData* surface, const CutPlane& plane);

/// Returns the face that the plane opens below such a line, straight down to z = bottom.
[[nodiscard]] vtkSmartPointer<vtkPolyData> cutFace(vtkPolyData* line, const CutPlane& plane,
                                                   double bottom);

}  // namespace asperity
