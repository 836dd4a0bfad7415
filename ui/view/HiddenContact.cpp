#include "ui/view/HiddenContact.h"

#include "core/scene/Scene.h"
#include "ui/view/Shading.h"
#include "vtkplugins/module/StripGrid.h"
#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kAngles = 120;
constexpr int kCircles = 13;  // the first is the contact's middle
constexpr double kDentOpacity = 0.4;
constexpr double kRimOpacity = 0.4;

void makeFaint(vtkActor* actor, double opacity) {
    actor->GetProperty()->SetOpacity(opacity);
    actor->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
}

/// Points of the surface at rest below a circle about the contact's axis.
std::vector<Vector3> circleAtRest(const Scene& scene, const TipContact& contact, double radius) {
    const Vector3 across = contact.normal.unitOrthogonal();
    const Vector3 third = contact.normal.cross(across);
    std::vector<Vector3> circle;
    for (int i = 0; i <= kAngles; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % kAngles) / kAngles;
        const Vector3 place =
            contact.closest + radius * (std::cos(angle) * across + std::sin(angle) * third);
        circle.emplace_back(place.x(), place.y(), scene.surface.at(place.x(), place.y()).height);
    }
    return circle;
}

}  // namespace

std::vector<Vector3> circleInContact(const Scene& scene, const ContactShape& shape, double radius) {
    std::vector<Vector3> circle = circleAtRest(scene, shape.contact(), radius);
    for (Vector3& place : circle) {
        place = shape.moved(place);
    }
    return circle;
}

HiddenContact::HiddenContact(vtkRenderer* through) {
    points_->SetDataTypeToDouble();
    rgb_->SetNumberOfComponents(3);
    inside_->SetPoints(points_);
    inside_->SetStrips(gridStrips(kAngles + 1, kCircles));
    inside_->GetPointData()->SetScalars(rgb_);
    dent_ = surfaceAsColored(inside_);
    vtkNew<vtkPolyData> nothing;
    rim_ = linesAsDrawn(nothing, palette::kContact, 2.0);
    makeFaint(dent_, kDentOpacity);
    makeFaint(rim_, kRimOpacity);
    through->AddActor(dent_);
    through->AddActor(rim_);
    hide();
}

HiddenContact::~HiddenContact() = default;

void HiddenContact::showRim(vtkPolyData* rim, const DrawnSpace& space) {
    vtkPolyDataMapper::SafeDownCast(rim_->GetMapper())->SetInputData(rim);
    space.apply(rim_);
    rim_->VisibilityOn();
}

void HiddenContact::showDent(const Scene& scene, const ContactShape& shape,
                             const PatchColors& colors, const DrawnSpace& space) {
    const TipContact& contact = shape.contact();
    points_->Reset();
    rgb_->Reset();
    for (int circle = 0; circle < kCircles; ++circle) {
        const double radius = contact.contactRadius * circle / (kCircles - 1);
        for (const Vector3& rest : circleAtRest(scene, contact, radius)) {
            const Vector3 place = shape.moved(rest);
            points_->InsertNextPoint(place.data());
            const double pushed = (rest - place).dot(contact.normal);
            const Vector3 normal = scene.surface.at(rest.x(), rest.y()).normal();
            const Color color = colors.of(rest, normal, pushed);
            rgb_->InsertNextTypedTuple(std::array{color.red, color.green, color.blue}.data());
        }
    }
    points_->Modified();
    rgb_->Modified();
    space.apply(dent_);
    dent_->VisibilityOn();
}

void HiddenContact::hide() {
    dent_->VisibilityOff();
    rim_->VisibilityOff();
}

}  // namespace asperity
