#pragma once

#include "core/Vector.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPolyData;

namespace asperity {

/// Distance of grid lines for a surface of this width: a round number, some thirty lines [m].
[[nodiscard]] double gridSpacing(double width);

/// Multiples of the spacing between two places, both excluded.
[[nodiscard]] std::vector<double> gridPlaces(double low, double high, double spacing);

/// Thin lines that let the surface below them shine through. They are blended over what is drawn
/// before them, and VTK takes them for opaque: its own passes for translucent things take longer
/// than all the rest of a frame.
[[nodiscard]] vtkSmartPointer<vtkActor> thinLines(vtkPolyData* data);

/// Several lines, one after another, for drawing.
class Polylines {
public:
    Polylines();
    void add(const std::vector<Vector3>& points);
    [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const { return data_; }

private:
    vtkSmartPointer<vtkPolyData> data_;
};

}  // namespace asperity
