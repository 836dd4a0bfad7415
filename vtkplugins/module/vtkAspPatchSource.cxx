#include "vtkplugins/module/vtkAspPatchSource.h"

#include "vtkplugins/module/StripGrid.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkAspPatchSource)

namespace {

/// Normal of the resting surface by central differences (one-sided at the border).
asperity::Vector3 restNormal(const asperity::SurfacePatch& patch, int row, int column) {
    const auto rest = [&patch](int r, int c) -> const asperity::Vector3& {
        return patch.rest[patch.index(std::clamp(r, 0, patch.rows - 1),
                                      std::clamp(c, 0, patch.columns - 1))];
    };
    const asperity::Vector3 alongX = rest(row, column + 1) - rest(row, column - 1);
    const asperity::Vector3 alongY = rest(row + 1, column) - rest(row - 1, column);
    // Scaled first: the product of two sides of a picometer patch is below Eigen's own zero.
    return alongX.normalized().cross(alongY.normalized()).normalized();
}

bool isComplete(const asperity::SurfacePatch& patch) {
    if (patch.columns < 2 || patch.rows < 2) {
        return false;
    }
    const std::size_t count = patch.index(patch.rows, 0);
    return patch.rest.size() == count && patch.points.size() == count &&
           patch.normals.size() == count;
}

}  // namespace

vtkAspPatchSource::vtkAspPatchSource() { this->SetNumberOfInputPorts(0); }

void vtkAspPatchSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Patch: " << this->Patch.columns << " x " << this->Patch.rows << "\n";
}

void vtkAspPatchSource::SetPatch(asperity::SurfacePatch patch) {
    this->Patch = std::move(patch);
    this->Modified();
}

int vtkAspPatchSource::RequestData(vtkInformation* /*request*/, vtkInformationVector** /*input*/,
                                   vtkInformationVector* outputVector) {
    const asperity::SurfacePatch& patch = this->Patch;
    if (!isComplete(patch)) {
        vtkErrorMacro("needs a patch of at least 2 x 2 points, each with its rest and its normal");
        return 0;
    }
    const auto count = static_cast<vtkIdType>(patch.points.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkNew<vtkDoubleArray> displacements;
    displacements->SetName("displacement");
    displacements->SetNumberOfTuples(count);
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const std::size_t index = patch.index(row, column);
            const auto id = static_cast<vtkIdType>(index);
            points->SetPoint(id, patch.points[index].data());
            normals->SetTuple(id, patch.normals[index].data());
            displacements->SetValue(
                id, (patch.rest[index] - patch.points[index]).dot(restNormal(patch, row, column)));
        }
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector);
    output->SetPoints(points);
    output->SetStrips(asperity::gridStrips(patch.columns, patch.rows));
    output->GetPointData()->SetNormals(normals);
    output->GetPointData()->SetScalars(displacements);
    return 1;
}
