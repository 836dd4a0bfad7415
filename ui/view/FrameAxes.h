#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <functional>

namespace asperity {

class Painter;
struct PixelPoint;

/// Axes along the two lower edges of a frame that face the eye.
struct FrameAxes {
    ScanWindow window;
    double bottom = 0.0;               ///< z of the edges, as drawn [m]
    Vector3 toEye = Vector3::UnitZ();  ///< unit
};

/// Paints edges, ticks and positions in the scan with their unit.
/// @param project where a place as drawn [m] is in the picture
void paintAxes(Painter& painter, const FrameAxes& axes,
               const std::function<PixelPoint(const Vector3&)>& project);

}  // namespace asperity
