#include "ui/view/TipLayer.h"

#include "ui/Theme.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace asperity {

namespace {

constexpr int kTipFacets = 64;
constexpr double kMinDrop = 0.05;  // shorter drop lines are not drawn; part of the tip's radius

}  // namespace

Vector3 apexOf(const TipContact& contact) {
    return contact.tipCenter - contact.tipRadius * Vector3::UnitZ();
}

TipLayer::TipLayer(vtkRenderer* renderer) {
    source_->SetResolution(kTipFacets);
    solid_ = surfaceAsColored(body_);
    solid_->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
    renderer->AddActor(solid_);
    vtkNew<vtkPolyData> nothing;
    drop_ = linesAsDrawn(nothing, theme::palette().muted, 1.0);
    renderer->AddActor(drop_);
    hide();
}

TipLayer::~TipLayer() = default;

void TipLayer::hide() {
    solid_->VisibilityOff();
    drop_->VisibilityOff();
}

void TipLayer::show(const ContactShape& shape, const TipStyle& style) {
    const TipContact& contact = shape.contact();
    source_->SetRadius(contact.tipRadius);
    source_->SetHalfAngle(contact.tip().shankHalfAngle());
    source_->SetCenter(contact.tipCenter.x(), contact.tipCenter.y(), contact.tipCenter.z());
    source_->SetParaboloidReach(style.paraboloidReach);
    source_->SetHeight(style.height / style.space.heightScale);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    deform(shape);
    paint(body_, theme::palette().tipBody, style.shading);
    solid_->GetProperty()->SetOpacity(style.opacity);
    solid_->GetProperty()->SetBackfaceCulling(style.opacity < 1.0 ? 1 : 0);
    style.space.apply(solid_);
    style.space.apply(drop_);
    solid_->VisibilityOn();
    showDrop(shape);
}

/// Moves the tip's surface by the tip's own share of the displacement.
void TipLayer::deform(const ContactShape& shape) {
    if (shape.tipDisplacement(0.0) == 0.0) {  // a rigid tip
        return;
    }
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

void TipLayer::showDrop(const ContactShape& shape) {
    const TipContact& contact = shape.contact();
    if (-contact.indentation < kMinDrop * contact.tipRadius) {
        drop_->VisibilityOff();
        return;
    }
    vtkPolyDataMapper::SafeDownCast(drop_->GetMapper())
        ->SetInputData(polyline({apexOf(contact), contact.closest}));
    drop_->GetProperty()->SetColor(theme::palette().muted.fractions().data());
    drop_->VisibilityOn();
}

}  // namespace asperity
