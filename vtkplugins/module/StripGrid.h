#pragma once

#include "core/Vector.h"

class vtkCellArray;
class vtkPolyData;

#include <vtkSmartPointer.h>

#include <vector>

namespace asperity {

/// A rectangle of a grid whose cells are left out, by the points on its edges.
struct GridHole {
    int left = 0;    ///< first column
    int right = 0;   ///< last column; not beyond the first: no hole
    int bottom = 0;  ///< first row
    int top = 0;     ///< last row
};

/// Triangle strips over a grid of points numbered row by row, one strip between two rows (two where
/// a hole parts them). Fronts face the side from which columns run right and rows run up.
vtkSmartPointer<vtkCellArray> gridStrips(int columns, int rows, const GridHole& hole = {});

/// One ring of a body of revolution.
struct ProfilePoint {
    double radius = 0.0;        ///< from the axis [m]
    double along = 0.0;         ///< along the axis [m]
    double normalRadial = 0.0;  ///< outward unit normal, its part away from the axis
    double normalAlong = 0.0;   ///< and its part along the axis
};

/// Fills `output` with the surface that `profile` sweeps about the axis through `origin`; the
/// profile runs along the axis, so that the outside is the front. A sharp edge takes two equal
/// points with two normals.
void revolveProfile(const std::vector<ProfilePoint>& profile, const Vector3& origin,
                    const Vector3& axis, int resolution, vtkPolyData* output);

}  // namespace asperity
