#include "ui/view/TipLayer.h"

#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"
#include "vtkplugins/pictures/Stretch.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kFacets = 48;
constexpr double kClear = 0.06;     // opacity of a wall that faces the eye
constexpr double kOutline = 0.75;   // and of one seen edge-on
constexpr double kFadeFrom = 0.35;  // part of the height
constexpr double kMinHeight = 0.4;  // of the tip, parts of the top's height
constexpr double kMinDrop = 0.05;   // shorter drop lines are not drawn; part of the tip's radius

}  // namespace

TipLayer::TipLayer(vtkRenderer* renderer) {
    source_->SetResolution(kFacets);
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
        const bool far = wall == 0;  // drawn first: it shows through the near one
        walls_.at(wall) = surfaceAsColored(body_);
        vtkActor* actor = walls_.at(wall);
        actor->GetProperty()->SetFrontfaceCulling(far ? 1 : 0);
        actor->GetProperty()->SetBackfaceCulling(far ? 0 : 1);
        actor->ForceOpaqueOn();  // blended all the same, without VTK's costly passes for glass
        renderer->AddActor(actor);
    }
    vtkNew<vtkPolyData> nothing;
    drop_ = linesAsDrawn(nothing, palette::kMuted, 1.0);
    renderer->AddActor(drop_);
    hide();
}

TipLayer::~TipLayer() = default;

void TipLayer::hide() {
    for (vtkActor* wall : walls_) {
        wall->VisibilityOff();
    }
    drop_->VisibilityOff();
}

void TipLayer::show(const ContactShape& shape, double magnification, const TipStyle& style) {
    const TipContact& contact = shape.contact();
    // Of the sphere alone any axis is as good: this one looks upright.
    const Vector3 axis = magnification > 1.0 ? shape.outward() : Vector3(Vector3::UnitZ());
    source_->SetRadius(contact.tipRadius);
    source_->SetCenter(contact.tipCenter.x(), contact.tipCenter.y(), contact.tipCenter.z());
    source_->SetAxis(axis.x(), axis.y(), axis.z());
    const double gap = magnification * std::max(0.0, -contact.indentation);
    const double height = std::max(style.top - gap, kMinHeight * style.top);
    source_->SetHeight(height / magnification);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    deform(shape);
    Vector3 apex = contact.tipCenter - contact.tipRadius * axis;
    if (magnification > 1.0) {
        const Stretch stretch(shape.patch(), shape.outward(), magnification);
        body_->ShallowCopy(stretch.apply(body_));
        apex = stretch.point(apex);
    }
    makeGlass(apex, height, style);
    showDrop(shape, apex);
    for (vtkActor* wall : walls_) {
        wall->VisibilityOn();
    }
}

/// Moves the tip's surface by the tip's own share of the displacement.
void TipLayer::deform(const ContactShape& shape) {
    const Vector3& axis = shape.outward();
    const Vector3& center = shape.contact().tipCenter;
    vtkPoints* undeformed = body_->GetPoints();  // the source's own: it may give them out again
    vtkNew<vtkPoints> deformed;
    deformed->SetDataTypeToDouble();
    deformed->SetNumberOfPoints(undeformed->GetNumberOfPoints());
    for (vtkIdType id = 0; id < undeformed->GetNumberOfPoints(); ++id) {
        const Vector3 point(undeformed->GetPoint(id));
        const Vector3 arm = point - center;
        const double distance = (arm - arm.dot(axis) * axis).norm();
        deformed->SetPoint(id, Vector3(point + shape.tipDisplacement(distance) * axis).data());
    }
    body_->SetPoints(deformed);
}

/// Clear where one looks straight through a wall, so that the contact is seen; denser where the
/// walls turn away, so that the tip keeps its outline.
void TipLayer::makeGlass(const Vector3& apex, double height, const TipStyle& style) {
    const Vector3 axis(source_->GetAxis());
    const vtkIdType count = body_->GetNumberOfPoints();
    vtkDataArray* normals = body_->GetPointData()->GetNormals();
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    rgba->SetNumberOfTuples(count);
    for (vtkIdType id = 0; id < count; ++id) {
        const double above = (Vector3(body_->GetPoint(id)) - apex).dot(axis) / height;
        const double faded = std::clamp((above - kFadeFrom) / (1.0 - kFadeFrom), 0.0, 1.0);
        const Vector3 normal(normals->GetTuple(id));
        const double facing = std::abs(normal.dot(style.toEye));
        const double opacity = std::lerp(kOutline, kClear, std::sqrt(facing)) *
                               (1.0 - faded * faded * (3.0 - 2.0 * faded));
        const auto [red, green, blue] = style.shading.lit(palette::kTip, normal);
        rgba->SetTuple4(id, red, green, blue, std::round(255.0 * opacity));
    }
    body_->GetPointData()->SetScalars(rgba);
}

void TipLayer::showDrop(const ContactShape& shape, const Vector3& apex) {
    const TipContact& contact = shape.contact();
    if (-contact.indentation < kMinDrop * contact.tipRadius) {
        drop_->VisibilityOff();
        return;
    }
    vtkPolyDataMapper::SafeDownCast(drop_->GetMapper())
        ->SetInputData(polyline({apex, contact.closest}));
    drop_->VisibilityOn();
}

}  // namespace asperity
