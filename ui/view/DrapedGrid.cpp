#include "ui/view/DrapedGrid.h"

#include "vtkplugins/pictures/SceneParts.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <cmath>

namespace asperity {

namespace {

constexpr double kLinesAcross = 25.0;
constexpr double kGridOpacity = 0.3;

}  // namespace

double gridSpacing(double width) { return niceBelow(width / kLinesAcross); }

std::vector<double> gridPlaces(double low, double high, double spacing) {
    std::vector<double> places;
    for (auto line = std::llround(std::floor(low / spacing)) + 1;; ++line) {
        const double place = static_cast<double>(line) * spacing;
        if (!(place < high)) {
            break;
        }
        places.push_back(place);
    }
    return places;
}

vtkSmartPointer<vtkActor> thinLines(vtkPolyData* data) {
    vtkSmartPointer<vtkActor> actor = linesAsDrawn(data, palette::kSurfaceLine, 1.0);
    actor->GetProperty()->SetOpacity(kGridOpacity);
    actor->ForceOpaqueOn();
    return actor;
}

Polylines::Polylines() : data_(vtkSmartPointer<vtkPolyData>::New()) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data_->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    data_->SetLines(cells);
}

void Polylines::add(const std::vector<Vector3>& points) {
    vtkCellArray* cells = data_->GetLines();
    cells->InsertNextCell(static_cast<int>(points.size()));
    for (const Vector3& point : points) {
        cells->InsertCellPoint(data_->GetPoints()->InsertNextPoint(point.data()));
    }
}

}  // namespace asperity
