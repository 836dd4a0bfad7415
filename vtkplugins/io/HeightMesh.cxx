#include "vtkplugins/io/HeightMesh.h"

#include "core/Error.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace asperity {

namespace {

/// Between a row and the one above it.
void addTriangles(vtkCellArray* triangles, vtkDoubleArray* heights, vtkIdType first, int columns) {
    const auto hasHeight = [&](vtkIdType point) {
        return isFiniteHeight(heights->GetValue(point));
    };
    for (vtkIdType corner = first; corner + 1 < first + columns; ++corner) {
        const vtkIdType above = corner + columns;
        if (hasHeight(corner) && hasHeight(corner + 1) && hasHeight(above) &&
            hasHeight(above + 1)) {
            triangles->InsertNextCell({corner, corner + 1, above + 1});
            triangles->InsertNextCell({corner, above + 1, above});
        }
    }
}

}  // namespace

void requireWritten(bool isWritten) {
    if (!isWritten) {
        throw Error("writing stopped half-way (disk full?)");
    }
}

vtkSmartPointer<vtkDoubleArray> heightArray(const HeightRows& map, Progress* progress) {
    auto heights = vtkSmartPointer<vtkDoubleArray>::New();
    heights->SetName("height");
    heights->SetNumberOfTuples(static_cast<vtkIdType>(map.columns) * map.rows);
    forEachRow(map, progress, [&](int row, const std::vector<double>& values) {
        const auto first = static_cast<vtkIdType>(map.rows - 1 - row) * map.columns;
        std::ranges::copy(values, heights->GetPointer(first));
    });
    return heights;
}

vtkSmartPointer<vtkPoints> pointsOf(const HeightRows& map, vtkDoubleArray* heights, int rowsBelow) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(heights->GetNumberOfTuples());
    vtkIdType id = 0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column, ++id) {
            const double height = heights->GetValue(id);
            points->SetPoint(id, (column + 0.5) * map.pitchX, (rowsBelow + row + 0.5) * map.pitchY,
                             isFiniteHeight(height) ? height : 0.0);
        }
    }
    return points;
}

vtkSmartPointer<vtkPolyData> meshOf(const HeightRows& map, vtkDoubleArray* heights, int rowsBelow,
                                    Progress* progress) {
    constexpr vtkIdType kIdsAPixel = 6;
    const vtkNew<vtkCellArray> triangles;
    if (kIdsAPixel * heights->GetNumberOfTuples() < std::numeric_limits<vtkTypeInt32>::max()) {
        triangles->Use32BitStorage();
    }
    triangles->AllocateExact(2 * heights->GetNumberOfTuples(),
                             kIdsAPixel * heights->GetNumberOfTuples());
    for (int row = 0; row + 1 < map.rows; ++row) {
        reportTo(progress, static_cast<double>(row) / map.rows);
        addTriangles(triangles, heights, static_cast<vtkIdType>(row) * map.columns, map.columns);
    }
    reportTo(progress, 1.0);
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(pointsOf(map, heights, rowsBelow));
    mesh->SetPolys(triangles);
    mesh->GetPointData()->SetScalars(heights);
    return mesh;
}

}  // namespace asperity
