#include "ui/view/MarkerLayer.h"

#include "ui/Theme.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace asperity {

namespace {

constexpr double kArm = 0.012;        // half a cross along x, in parts of the window's width
constexpr double kMarkerWidth = 2.0;  // [px]
constexpr int kStretches = 6;         // of an arm: it lies on the surface

bool holds(const ScanWindow& window, const Marker& marker) {
    return marker.x >= window.left && marker.x <= window.right && marker.y >= window.bottom &&
           marker.y <= window.top;
}

/// Through the marker along (1, slope).
std::vector<Vector3> armOf(const Marker& marker, const BSplineSurface& surface, double half,
                           double slope) {
    std::vector<Vector3> points;
    for (int i = -kStretches; i <= kStretches; ++i) {
        const double way = half * i / kStretches;
        const double x = marker.x + way;
        const double y = marker.y + slope * way;
        points.emplace_back(x, y, surface.at(x, y).height);
    }
    return points;
}

}  // namespace

MarkerLayer::MarkerLayer(vtkRenderer* renderer) {
    vtkNew<vtkPolyData> nothing;
    lines_ = linesAsDrawn(nothing, theme::palette().ink, kMarkerWidth);
    renderer->AddActor(lines_);
    hide();
}

MarkerLayer::~MarkerLayer() = default;

void MarkerLayer::hide() {
    lines_->VisibilityOff();
    names_.clear();
}

void MarkerLayer::show(const std::vector<Marker>& markers, const BSplineSurface& surface,
                       const ScanWindow& window, const DrawnSpace& space) {
    hide();
    const double half = kArm * (window.right - window.left);
    vtkNew<vtkAppendPolyData> all;
    for (const Marker& marker : markers) {
        if (holds(window, marker)) {
            all->AddInputData(polyline(armOf(marker, surface, half, 1.0)));
            all->AddInputData(polyline(armOf(marker, surface, half, -1.0)));
            const Vector3 place(marker.x, marker.y, surface.at(marker.x, marker.y).height);
            names_.push_back({space.point(place), marker.name, theme::palette().ink});
        }
    }
    if (names_.empty()) {
        return;
    }
    all->Update();
    vtkPolyDataMapper::SafeDownCast(lines_->GetMapper())->SetInputData(all->GetOutput());
    lines_->GetProperty()->SetColor(theme::palette().ink.fractions().data());
    space.apply(lines_);
    lines_->VisibilityOn();
}

}  // namespace asperity
