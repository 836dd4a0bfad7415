#include "vtkplugins/module/StripGrid.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace asperity {

vtkSmartPointer<vtkCellArray> gridStrips(int columns, int rows, const GridHole& hole) {
    auto strips = vtkSmartPointer<vtkCellArray>::New();
    strips->AllocateEstimate(rows, 2 * static_cast<vtkIdType>(columns));
    const auto addStrip = [&](int row, int first, int last) {
        if (first >= last) {
            return;
        }
        strips->InsertNextCell(2 * (last - first + 1));
        const vtkIdType lower = static_cast<vtkIdType>(row) * columns;
        for (int column = first; column <= last; ++column) {
            strips->InsertCellPoint(lower + columns + column);
            strips->InsertCellPoint(lower + column);
        }
    };
    for (int row = 0; row + 1 < rows; ++row) {
        if (hole.left < hole.right && row >= hole.bottom && row < hole.top) {
            addStrip(row, 0, hole.left);
            addStrip(row, hole.right, columns - 1);
        } else {
            addStrip(row, 0, columns - 1);
        }
    }
    return strips;
}

void revolveProfile(const std::vector<ProfilePoint>& profile, const Vector3& origin,
                    const Vector3& axis, int resolution, vtkPolyData* output) {
    const Vector3 along = axis.normalized();
    const Vector3 across = along.unitOrthogonal();
    const Vector3 third = along.cross(across);
    const int rows = static_cast<int>(profile.size());
    const int columns = resolution + 1;  // the seam's points are there twice

    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(rows) * columns);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(points->GetNumberOfPoints());
    vtkIdType id = 0;
    for (const ProfilePoint& ring : profile) {
        for (int column = 0; column < columns; ++column, ++id) {
            const double angle = 2.0 * std::numbers::pi * (column % resolution) / resolution;
            const Vector3 radial = std::cos(angle) * across + std::sin(angle) * third;
            const Vector3 point = origin + ring.radius * radial + ring.along * along;
            const Vector3 normal = ring.normalRadial * radial + ring.normalAlong * along;
            points->SetPoint(id, point.data());
            normals->SetTuple(id, normal.data());
        }
    }
    output->SetPoints(points);
    output->SetStrips(gridStrips(columns, rows));
    output->GetPointData()->SetNormals(normals);
}

}  // namespace asperity
