#include "ui/view/MarkerLayer.h"

#include "ui/view/TerrainLayer.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QObject>

#include <cmath>
#include <numbers>

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

constexpr int kPoints = 192;  // of each line
constexpr double kCrossHairWidth = 1.5;

constexpr double kTargetWidth = 3.0;  // [px]
constexpr double kEdgeWidth = 5.0;    // [px]
constexpr double kTargetRing = 0.3;   // its radius, in arms
constexpr int kRingPoints = 48;

Vector3 onSurface(const BSplineSurface& surface, double x, double y) {
    return {x, y, surface.at(x, y).height};
}

std::vector<Vector3> ring(const BSplineSurface& surface, const Vector3& target, double radius) {
    std::vector<Vector3> points;
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kRingPoints;
        points.push_back(onSurface(surface, target.x() + radius * std::cos(angle),
                                   target.y() + radius * std::sin(angle)));
    }
    return points;
}

void draw(vtkActor& actor, vtkPolyData* data, const Color& color, const DrawnSpace& space) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
    actor.GetProperty()->SetColor(color.fractions().data());
    space.apply(&actor);
    actor.VisibilityOn();
}

constexpr double kMarkerArm = 0.012;  // half a cross along x, in parts of the window's width
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

CrossHairLayer::CrossHairLayer(vtkRenderer* renderer) {
    vtkNew<vtkPolyData> nothing;
    lines_ = linesAsDrawn(nothing, theme::palette().marker, kCrossHairWidth);
    renderer->AddActor(lines_);
    hide();
}

CrossHairLayer::~CrossHairLayer() = default;

void CrossHairLayer::hide() { lines_->VisibilityOff(); }

void CrossHairLayer::show(const BSplineSurface& surface, const Vector2& position,
                          const ScanWindow& window, const ContactShape* contact,
                          const DrawnSpace& space) {
    if (!holds(window, position)) {
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
        alongX.push_back(drawn({std::lerp(window.left, window.right, part), position.y()}));
        alongY.push_back(drawn({position.x(), std::lerp(window.bottom, window.top, part)}));
    }
    cross.add(alongX);
    cross.add(alongY);
    vtkPolyDataMapper::SafeDownCast(lines_->GetMapper())->SetInputData(cross.data());
    lines_->GetProperty()->SetColor(theme::palette().marker.fractions().data());
    space.apply(lines_);
    lines_->VisibilityOn();
}

TargetLayer::TargetLayer(vtkRenderer* through) {
    vtkNew<vtkPolyData> nothing;
    edge_ = linesAsDrawn(nothing, palette::kSurfaceLine, kEdgeWidth);
    lines_ = linesAsDrawn(nothing, theme::palette().target, kTargetWidth);
    through->AddActor(edge_);
    through->AddActor(lines_);
    hide();
}

TargetLayer::~TargetLayer() = default;

void TargetLayer::hide() {
    edge_->VisibilityOff();
    lines_->VisibilityOff();
    name_.reset();
}

void TargetLayer::show(const Vector3& target, const BSplineSurface& surface, double arm,
                       const DrawnSpace& space) {
    Polylines cross;
    for (const Vector3& axis : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()),
                                Vector3(Vector3::UnitZ() / space.heightScale)}) {
        cross.add({target - arm * axis, target + arm * axis});
    }
    cross.add({target, onSurface(surface, target.x(), target.y())});
    cross.add(ring(surface, target, kTargetRing * arm));
    draw(*edge_, cross.data(), palette::kSurfaceLine, space);
    draw(*lines_, cross.data(), theme::palette().target, space);
    name_ = {.position = space.point(target),
             .text = QObject::tr("target").toStdString(),
             .color = theme::palette().ink};
}

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
    const double half = kMarkerArm * (window.right - window.left);
    vtkNew<vtkAppendPolyData> all;
    for (const Marker& marker : markers) {
        if (holds(window, marker)) {
            all->AddInputData(polyline(armOf(marker, surface, half, 1.0)));
            all->AddInputData(polyline(armOf(marker, surface, half, -1.0)));
            const Vector3 position(marker.x, marker.y, surface.at(marker.x, marker.y).height);
            names_.push_back({space.point(position), marker.name, theme::palette().ink});
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
