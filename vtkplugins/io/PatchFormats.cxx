#include "vtkplugins/io/PatchFormats.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLStructuredGridWriter.h>

#include <initializer_list>
#include <vector>

namespace asperity {

namespace {

vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, const std::vector<Vector3>& vectors) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        array->SetTuple(static_cast<vtkIdType>(i), vectors[i].data());
    }
    return array;
}

void setPoints(vtkPointSet* data, const SurfacePatch& patch) {
    std::vector<Vector3> displacements;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        displacements.emplace_back(patch.points[i] - patch.rest[i]);
    }
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf("points", patch.points));
    data->SetPoints(points);
    data->GetPointData()->AddArray(arrayOf("rest", patch.rest));
    data->GetPointData()->AddArray(arrayOf("displacement", displacements));
    data->GetPointData()->SetNormals(arrayOf("normal", patch.normals));
}

template <class Writer>
void write(const std::filesystem::path& path, vtkDataObject* data) {
    const TemporaryFile file(path);
    vtkNew<Writer> writer;
    writer->SetInputData(data);
    writer->SetFileName(file.path().c_str());
    if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError) {
        throw Error(path.string() + ": writing stopped half-way (disk full?)");
    }
    file.commit();
}

}  // namespace

void writePatchVtp(const std::filesystem::path& path, const SurfacePatch& patch) {
    vtkNew<vtkPolyData> mesh;
    setPoints(mesh, patch);
    vtkNew<vtkCellArray> triangles;
    for (int row = 0; row + 1 < patch.rows; ++row) {
        for (int column = 0; column + 1 < patch.columns; ++column) {
            const auto a = static_cast<vtkIdType>(patch.index(row, column));
            const vtkIdType b = a + 1;
            const auto d = static_cast<vtkIdType>(patch.index(row + 1, column));
            const vtkIdType c = d + 1;
            triangles->InsertNextCell({a, b, c});
            triangles->InsertNextCell({a, c, d});
        }
    }
    mesh->SetPolys(triangles);
    write<vtkXMLPolyDataWriter>(path, mesh);
}

void writePatchVts(const std::filesystem::path& path, const SurfacePatch& patch) {
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(patch.columns, patch.rows, 1);
    setPoints(grid, patch);
    write<vtkXMLStructuredGridWriter>(path, grid);
}

}  // namespace asperity
