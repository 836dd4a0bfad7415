#include "ui/view/GuideLayer.h"

#include "ui/Theme.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <vector>

namespace asperity {

namespace {

constexpr double kCross = 0.12;  // half a cross, in parts of the reach
constexpr double kGuideWidth = 2.0;

using GuideStroke = std::vector<Vector3>;

GuideStroke through(const Vector3& point, const Vector3& half) {
    return {point - half, point + half};
}

std::vector<GuideStroke> cross(const Vector3& point, double half) {
    return {through(point, half * Vector3::UnitX()), through(point, half * Vector3::UnitY()),
            through(point, half * Vector3::UnitZ())};
}

std::vector<GuideStroke> square(const Vector3& point, const Vector3& axis, double half) {
    const Vector3 one = half * axis.unitOrthogonal();
    const Vector3 other = axis.cross(one);
    const GuideStroke frame{point + one + other, point - one + other, point - one - other,
                            point + one - other, point + one + other};
    return {frame, through(point, one), through(point, other)};
}

std::vector<GuideStroke> strokesOf(const VirtualFixture& guide, double reach) {
    switch (guide.kind) {
    case FixtureKind::Point:
        return cross(guide.point, kCross * reach);
    case FixtureKind::Line:
        return {through(guide.point, reach * guide.axis)};
    case FixtureKind::Plane:
        return square(guide.point, guide.axis, reach);
    case FixtureKind::None:
        break;
    }
    return {};
}

}  // namespace

GuideLayer::GuideLayer(vtkRenderer* renderer) {
    vtkNew<vtkPolyData> nothing;
    lines_ = linesAsDrawn(nothing, theme::palette().guide, kGuideWidth);
    renderer->AddActor(lines_);
    hide();
}

GuideLayer::~GuideLayer() = default;

void GuideLayer::hide() { lines_->VisibilityOff(); }

void GuideLayer::show(const VirtualFixture& guide, double reach, const DrawnSpace& space) {
    const std::vector<GuideStroke> strokes = strokesOf(guide, reach);
    if (strokes.empty()) {
        hide();
        return;
    }
    vtkNew<vtkAppendPolyData> all;
    for (const GuideStroke& stroke : strokes) {
        all->AddInputData(polyline(stroke));
    }
    all->Update();
    vtkPolyDataMapper::SafeDownCast(lines_->GetMapper())->SetInputData(all->GetOutput());
    lines_->GetProperty()->SetColor(theme::palette().guide.fractions().data());
    space.apply(lines_);
    lines_->VisibilityOn();
}

}  // namespace asperity
