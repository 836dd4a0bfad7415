#include "ui/view/CrossHairLayer.h"

#include "ui/Theme.h"
#include "ui/view/DrapedGrid.h"
#include "ui/view/ViewFrame.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kPoints = 192;  // of each line
constexpr double kCrossHairWidth = 1.5;

}  // namespace

CrossHairLayer::CrossHairLayer(vtkRenderer* renderer) {
    vtkNew<vtkPolyData> nothing;
    lines_ = linesAsDrawn(nothing, theme::palette().marker, kCrossHairWidth);
    renderer->AddActor(lines_);
    hide();
}

CrossHairLayer::~CrossHairLayer() = default;

void CrossHairLayer::hide() { lines_->VisibilityOff(); }

void CrossHairLayer::show(const BSplineSurface& surface, const Vector2& place,
                          const ScanWindow& window, const ContactShape* contact,
                          const DrawnSpace& space) {
    if (!holds(window, place)) {
        hide();
        return;
    }
    const auto drawn = [&](const Vector2& at) -> Vector3 {
        const Vector3 rest(at.x(), at.y(), surface.at(at.x(), at.y()).height);
        return contact != nullptr && holds(contact->area(), at) ? contact->moved(rest) : rest;
    };
    Polylines cross;
    std::vector<Vector3> alongX;
    std::vector<Vector3> alongY;
    for (int i = 0; i <= kPoints; ++i) {
        const double part = static_cast<double>(i) / kPoints;
        alongX.push_back(drawn({std::lerp(window.left, window.right, part), place.y()}));
        alongY.push_back(drawn({place.x(), std::lerp(window.bottom, window.top, part)}));
    }
    cross.add(alongX);
    cross.add(alongY);
    vtkPolyDataMapper::SafeDownCast(lines_->GetMapper())->SetInputData(cross.data());
    lines_->GetProperty()->SetColor(theme::palette().marker.fractions().data());
    space.apply(lines_);
    lines_->VisibilityOn();
}

}  // namespace asperity
