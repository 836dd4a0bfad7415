#include "vtkplugins/pictures/Stretch.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace asperity {

vtkSmartPointer<vtkPolyData> Stretch::apply(vtkPolyData* data) const {
    auto stretched = vtkSmartPointer<vtkPolyData>::New();
    stretched->ShallowCopy(data);
    const vtkIdType count = data->GetNumberOfPoints();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkDataArray* oldNormals = data->GetPointData()->GetNormals();
    for (vtkIdType id = 0; id < count; ++id) {
        points->SetPoint(id, point(Vector3(data->GetPoint(id))).data());
        if (oldNormals != nullptr) {
            normals->SetTuple(id, normal(Vector3(oldNormals->GetTuple(id))).data());
        }
    }
    stretched->SetPoints(points);
    if (oldNormals != nullptr) {
        stretched->GetPointData()->SetNormals(normals);
    }
    return stretched;
}

}  // namespace asperity
