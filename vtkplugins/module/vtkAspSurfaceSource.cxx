#include "vtkplugins/module/vtkAspSurfaceSource.h"

#include "vtkplugins/module/StripGrid.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkAspSurfaceSource)

namespace {

/// Positions of grid lines along one axis, about evenly spread, and which of them bound the hole.
struct GridAxis {
    std::vector<double> positions;
    int holeFirst = 0;
    int holeLast = 0;
};

void addPositions(std::vector<double>& positions, double end, int cells) {
    const double start = positions.back();
    for (int cell = 1; cell <= cells; ++cell) {
        positions.push_back(std::lerp(start, end, static_cast<double>(cell) / cells));
    }
}

/// @param window  where the axis begins and ends
/// @param hole    where the hole does; empty: none
GridAxis gridAxis(const double* window, const double* hole, int count) {
    GridAxis axis{.positions = {window[0]}};
    const double from = std::clamp(hole[0], window[0], window[1]);
    const double to = std::clamp(hole[1], window[0], window[1]);
    int left = count - 1;  // cells to be given out
    if (from < to && left >= 3) {
        const double perLength = left / (window[1] - window[0]);
        const auto cellsFor = [&](double length, int leave) {
            const int wanted = static_cast<int>(std::lround(length * perLength));
            const int given = length > 0.0 ? std::clamp(wanted, 1, left - leave) : 0;
            left -= given;
            return given;
        };
        axis.holeFirst = cellsFor(from - window[0], 2);
        addPositions(axis.positions, from, axis.holeFirst);
        axis.holeLast = axis.holeFirst + (to < window[1] ? cellsFor(to - from, 1) : left);
        addPositions(axis.positions, to, axis.holeLast - axis.holeFirst);
        left = count - 1 - axis.holeLast;
    }
    addPositions(axis.positions, window[1], left);
    return axis;
}

}  // namespace

vtkAspSurfaceSource::vtkAspSurfaceSource() { this->SetNumberOfInputPorts(0); }

void vtkAspSurfaceSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Surface: " << this->Surface << "\n";
    os << indent << "Window: " << this->Window[0] << " " << this->Window[1] << " "
       << this->Window[2] << " " << this->Window[3] << "\n";
    os << indent << "Resolution: " << this->Resolution[0] << " " << this->Resolution[1] << "\n";
    os << indent << "Hole: " << this->Hole[0] << " " << this->Hole[1] << " " << this->Hole[2] << " "
       << this->Hole[3] << "\n";
}

void vtkAspSurfaceSource::SetSurface(const asperity::BSplineSurface* surface) {
    this->Surface = surface;
    this->Modified();  // always: a new surface may lie where an old one was
}

int vtkAspSurfaceSource::RequestData(vtkInformation* /*request*/, vtkInformationVector** /*input*/,
                                     vtkInformationVector* outputVector) {
    const int columns = this->Resolution[0];
    const int rows = this->Resolution[1];
    if (this->Surface == nullptr || columns < 2 || rows < 2) {
        vtkErrorMacro("needs a surface and a resolution of at least 2 x 2");
        return 0;
    }
    const vtkIdType count = static_cast<vtkIdType>(columns) * rows;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkNew<vtkFloatArray> heights;
    heights->SetName("height");
    heights->SetNumberOfTuples(count);

    const GridAxis across = gridAxis(this->Window, this->Hole, columns);
    const GridAxis up = gridAxis(this->Window + 2, this->Hole + 2, rows);
    vtkIdType id = 0;
    for (const double y : up.positions) {
        for (const double x : across.positions) {
            const asperity::HeightSample sample = this->Surface->at(x, y);
            points->SetPoint(id, x, y, sample.height);
            normals->SetTuple(id, sample.normal().data());
            heights->SetValue(id, static_cast<float>(sample.height));
            ++id;
        }
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector);
    output->SetPoints(points);
    output->SetStrips(asperity::gridStrips(
        columns, rows, {across.holeFirst, across.holeLast, up.holeFirst, up.holeLast}));
    output->GetPointData()->SetNormals(normals);
    output->GetPointData()->SetScalars(heights);
    return 1;
}
