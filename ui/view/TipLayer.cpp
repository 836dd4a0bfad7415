#include "ui/view/TipLayer.h"

#include "core/scene/Scene.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <numbers>

namespace asperity {

namespace {

// In half widths of the lever.
constexpr double kClampEnd = -3.0;
constexpr double kFreeEnd = 1.2;
constexpr double kThickness = 0.15;

constexpr double kDegrees = 180.0 / std::numbers::pi;

constexpr int kTipFacets = 64;
constexpr double kMinDrop = 0.05;  // shorter drop lines are not drawn; part of the tip's radius

// In sizes of tip and arrow.
constexpr double kTipTop = 1.15;
constexpr double kSmallGear = 0.6;  // of the frame: from here on outwards the lever is in the view
constexpr double kLeverHalfWidth = 0.5;

// In half widths of the frame.
constexpr double kCapSize = 0.6;
constexpr double kCapWidth = 0.6;

constexpr double kCapOpacity = 0.4;

}  // namespace

LeverLayer::LeverLayer(vtkRenderer* renderer) : slab_(surfaceAsColored(data_)) {
    renderer->AddActor(slab_);
    hide();
}

LeverLayer::~LeverLayer() = default;

void LeverLayer::hide() { slab_->VisibilityOff(); }

void LeverLayer::show(const LeverPose& lever, const Shading& shading) {
    vtkNew<vtkCubeSource> slab;
    slab->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    slab->SetBounds(kClampEnd, kFreeEnd, -1.0, 1.0, 0.0, kThickness);
    vtkNew<vtkTransform> pose;
    pose->Translate(lever.shankTop.data());
    pose->RotateZ(kDegrees * lever.azimuth);
    pose->RotateY(kDegrees * lever.tilt);
    pose->Scale(lever.size, lever.size, lever.size);
    vtkNew<vtkTransformPolyDataFilter> placed;
    placed->SetInputConnection(slab->GetOutputPort());
    placed->SetTransform(pose);
    placed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    placed->Update();
    data_->ShallowCopy(placed->GetOutput());
    paint(data_, theme::palette().lever, shading);
    slab_->VisibilityOn();
}

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

double GearScale::size() const {
    return isCap() ? kCapSize * halfWidth : std::min(halfWidth, 1.5 * tipRadius + 0.4 * halfWidth);
}

double GearScale::tipHeight() const {
    return isCap() ? heightScale * RoundTip{tipRadius}.height(kCapWidth * halfWidth) : headroom();
}

double GearScale::headroom() const { return kTipTop * size(); }

bool GearScale::showsLever() const { return !isCap() && size() <= kSmallGear * halfWidth; }

void TipGear::hide() {
    tip_.hide();
    lever_.hide();
}

void TipGear::show(const Scene& scene, const ContactShape& shape, const GearScale& scale,
                   const DrawnSpace& space, const Shading& shading) {
    // A tip that is pressed deep into the surface still ends above it.
    constexpr double kAboveSurface = 0.6;  // of its usual height
    const double pressed =
        (space.heightScale * shape.contact().indentation) + (kAboveSurface * scale.tipHeight());
    const double height = scale.isCap() ? scale.tipHeight() : std::max(scale.tipHeight(), pressed);
    tip_.show(shape, {.height = height,
                      .paraboloidReach = scale.paraboloidReach,
                      .opacity = scale.isCap() ? kCapOpacity : 1.0,
                      .space = space,
                      .shading = shading});
    if (!scale.showsLever()) {
        lever_.hide();
        return;
    }
    const CantileverGeometry& lever = scene.description.probe;
    lever_.show({.shankTop = space.point(apexOf(shape.contact())) + height * Vector3::UnitZ(),
                 .size = kLeverHalfWidth * scale.size(),
                 .azimuth = lever.azimuth,
                 .tilt = lever.mountTilt},
                shading);
}

}  // namespace asperity
