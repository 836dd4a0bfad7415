#include "ui/view/TargetLayer.h"

#include "core/surface/BSplineSurface.h"
#include "ui/Theme.h"
#include "ui/view/DrapedGrid.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QObject>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kTargetWidth = 3.0;  // [px]
constexpr double kEdgeWidth = 5.0;    // [px]
constexpr double kRing = 0.3;         // its radius, in arms
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

}  // namespace

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
    cross.add(ring(surface, target, kRing * arm));
    draw(*edge_, cross.data(), palette::kSurfaceLine, space);
    draw(*lines_, cross.data(), theme::palette().target, space);
    name_ = {.place = space.point(target),
             .text = QObject::tr("target").toStdString(),
             .color = theme::palette().ink};
}

}  // namespace asperity
