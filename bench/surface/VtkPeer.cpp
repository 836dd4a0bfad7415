// VTK (BSD): its static cell locator on the mesh.
#include "bench/surface/MeshMethod.h"
#include "bench/surface/Peers.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

namespace asperity {

namespace {

/// In nanometers: VTK's own tolerances are absolute.
constexpr double kUnit = 1e-9;

class VtkLocator : public MeshLocator {
public:
    explicit VtkLocator(const SurfaceMesh& mesh) {
        const vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        for (const Vector3& point : mesh.points) {
            const Vector3 scaled = point / kUnit;
            points->InsertNextPoint(scaled.data());
        }
        const vtkNew<vtkCellArray> cells;
        for (const auto& triangle : mesh.triangles) {
            cells->InsertNextCell({triangle[0], triangle[1], triangle[2]});
        }
        data_->SetPoints(points);
        data_->SetPolys(cells);
        locator_->SetDataSet(data_);
        locator_->BuildLocator();
    }

    [[nodiscard]] std::string name() const override { return "VTK static cell locator"; }

    [[nodiscard]] Vector3 nearest(const Vector3& query, const Vector3& /*last*/) override {
        const Vector3 scaled = query / kUnit;
        Vector3 closest;
        vtkIdType id = 0;
        int part = 0;
        double squared = 0.0;
        locator_->FindClosestPoint(scaled.data(), closest.data(), cell_, id, part, squared);
        return closest * kUnit;
    }

private:
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkStaticCellLocator> locator_;
    vtkNew<vtkGenericCell> cell_;
};

}  // namespace

std::unique_ptr<SearchMethod> vtkMethod(const BSplineSurface& surface) {
    return meshMethod(surface, std::make_unique<VtkLocator>(meshOf(surface)));
}

}  // namespace asperity
