#include "vtkplugins/pictures/CutBlock.h"

#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <array>
#include <utility>

namespace asperity {

namespace {

vtkSmartPointer<vtkPlane> planeOf(const CutPlane& plane) {
    auto shown = vtkSmartPointer<vtkPlane>::New();
    shown->SetOrigin(plane.origin.data());
    shown->SetNormal(plane.toFront.data());
    return shown;
}

}  // namespace

vtkSmartPointer<vtkPolyData> behind(vtkPolyData* data, const CutPlane& plane) {
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(data);
    clip->SetClipFunction(planeOf(plane));
    clip->InsideOutOn();
    clip->Update();
    return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> cutLine(vtkPolyData* surface, const CutPlane& plane) {
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(surface);
    cutter->SetCutFunction(planeOf(plane));
    cutter->Update();
    return cutter->GetOutput();
}

vtkSmartPointer<vtkPolyData> cutFace(vtkPolyData* line, const CutPlane& plane, double bottom) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> quads;
    const auto add = [&](const Vector3& point) {
        normals->InsertNextTuple(plane.toFront.data());
        return points->InsertNextPoint(point.data());
    };
    vtkCellArray* segments = line->GetLines();
    for (vtkIdType cell = 0; cell < segments->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        segments->GetCellAtId(cell, count, ids);
        for (vtkIdType i = 0; i + 1 < count; ++i) {
            Vector3 one(line->GetPoint(ids[i]));
            Vector3 other(line->GetPoint(ids[i + 1]));
            if (plane.toFront.dot((other - one).cross(Vector3::UnitZ())) > 0.0) {
                std::swap(one, other);  // its front faces the eye
            }
            const std::array<vtkIdType, 4> corners{add(one), add(other),
                                                   add({other.x(), other.y(), bottom}),
                                                   add({one.x(), one.y(), bottom})};
            quads->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
        }
    }
    auto face = vtkSmartPointer<vtkPolyData>::New();
    face->SetPoints(points);
    face->SetPolys(quads);
    face->GetPointData()->SetNormals(normals);
    return face;
}

}  // namespace asperity
