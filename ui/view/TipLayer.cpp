#include "ui/view/TipLayer.h"

#include "core/SmoothStep.h"
#include "core/scene/Scene.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

// In half widths of the lever.
constexpr double kClampEnd = -3.0;
constexpr double kFreeEnd = 1.2;
constexpr double kThickness = 0.15;

constexpr double kDegrees = 180.0 / std::numbers::pi;

constexpr int kTipFacets = 64;
constexpr int kShankRings = 16;
constexpr double kMinDrop = 0.05;  // shorter drop lines are not drawn; part of the tip's radius

// In sizes of tip and arrow.
constexpr double kTipTop = 1.15;
constexpr double kSmallGear = 0.6;  // of the frame: from here on outwards the lever is in the view
constexpr double kLeverHalfWidth = 0.5;

// In half widths of the frame.
constexpr double kCapSize = 0.6;
constexpr double kCapWidth = 0.6;

// Opacity of one wall of the tip: two of them are seen through each other.
constexpr double kClearOpacity = 0.2;
constexpr double kSolidOpacity = 0.92;
constexpr double kCapOpacity = 0.3;

// Of the tip's radius: the eye of a usual view meets the tip there on its way to the contact.
constexpr double kClearHeight = 0.6;
// Of the height that is drawn.
constexpr double kMaxClear = 0.25;
constexpr double kFadingFrom = 0.6;
// In heights of the clear part.
constexpr double kSolidFrom = 1.7;

constexpr double kEdgeOpacity = 0.75;
constexpr double kEdgeWidth = 1.5;
constexpr double kEdgeShade = 0.5;  // of the body's color

/// Points with a color and an opacity.
vtkSmartPointer<vtkUnsignedCharArray> newColors(vtkIdType count) {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(4);
    colors->SetNumberOfTuples(count);
    return colors;
}

unsigned char alphaOf(double opacity) {
    return static_cast<unsigned char>(std::lround(255.0 * opacity));
}

unsigned char shaded(std::uint8_t part) {
    return static_cast<unsigned char>(std::lround(kEdgeShade * part));
}

}  // namespace

namespace {

/// Gives the slab of a lever no opacity at its clamped end. @param flat the slab before it is
/// placed
void fade(vtkPolyData& placed, vtkPolyData& flat) {
    auto* lit = vtkUnsignedCharArray::SafeDownCast(placed.GetPointData()->GetScalars());
    const auto colors = newColors(placed.GetNumberOfPoints());
    for (vtkIdType id = 0; id < placed.GetNumberOfPoints(); ++id) {
        std::array<unsigned char, 4> color{};
        lit->GetTypedTuple(id, color.data());
        color[3] = alphaOf(flat.GetPoint(id)[0] > 0.0 ? 1.0 : 0.0);
        colors->SetTypedTuple(id, color.data());
    }
    placed.GetPointData()->SetScalars(colors);
}

}  // namespace

double TipOpacity::fading(double z) const {
    const double from = std::lerp(apex, top, kFadingFrom);
    return isOpen ? 1.0 - smoothStep((z - from) / (top - from)) : 1.0;
}

double TipOpacity::at(double z) const {
    if (isCap) {
        return kCapOpacity * fading(z);
    }
    const double solid = smoothStep((z - apex - clear) / ((kSolidFrom - 1.0) * clear));
    return std::lerp(kClearOpacity, kSolidOpacity, solid) * fading(z);
}

LeverLayer::LeverLayer(vtkRenderer* renderer) : slab_(surfaceAsColored(data_)) {
    slab_->ForceOpaqueOn();                     // blended all the same, without VTK's costly passes
    slab_->GetProperty()->BackfaceCullingOn();  // its lower side lies on the tip's upper end
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
    fade(*data_, *slab->GetOutput());
    slab_->VisibilityOn();
}

double LeverLayer::rise(const LeverPose& lever, const Vector3& up) {
    const Eigen::AngleAxisd turn(lever.azimuth, Vector3::UnitZ());
    const Eigen::AngleAxisd tilt(lever.tilt, Vector3::UnitY());
    double highest = 0.0;
    for (const double along : {kClampEnd, kFreeEnd}) {
        for (const double across : {-1.0, 1.0}) {
            const Vector3 corner = turn * (tilt * Vector3(along, across, kThickness));
            highest = std::max(highest, lever.size * up.dot(corner));
        }
    }
    return highest;
}

Vector3 apexOf(const TipContact& contact) {
    return contact.tipCenter - contact.tipRadius * Vector3::UnitZ();
}

TipLayer::TipLayer(vtkRenderer* renderer) {
    source_->SetResolution(kTipFacets);
    source_->SetShankRings(kShankRings);
    vtkNew<vtkPolyData> nothing;
    edge_ = linesAsDrawn(nothing, {}, kEdgeWidth);
    edge_->GetMapper()->ScalarVisibilityOn();
    edge_->GetMapper()->SetColorModeToDirectScalars();
    for (vtkSmartPointer<vtkActor>& wall : walls_) {
        wall = surfaceAsColored(body_);
        wall->GetProperty()->SetFrontfaceCulling(wall == walls_.front() ? 1 : 0);
        wall->GetProperty()->SetBackfaceCulling(wall == walls_.front() ? 0 : 1);
    }
    for (vtkActor* actor : {walls_[0].Get(), walls_[1].Get(), edge_.Get()}) {
        actor->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
        renderer->AddActor(actor);
    }
    drop_ = linesAsDrawn(nothing, theme::palette().muted, 1.0);
    renderer->AddActor(drop_);
    hide();
}

TipLayer::~TipLayer() = default;

void TipLayer::hide() {
    for (vtkActor* actor : {walls_[0].Get(), walls_[1].Get(), edge_.Get(), drop_.Get()}) {
        actor->VisibilityOff();
    }
}

void TipLayer::show(const ContactShape& shape, const TipStyle& style) {
    const TipContact& contact = shape.contact();
    const double height = style.height / style.space.heightScale;
    if (!(height > 0.0)) {  // all of it is above the picture
        body_->Initialize();
        hide();
        return;
    }
    source_->SetRadius(contact.tipRadius);
    source_->SetHalfAngle(contact.tip().shankHalfAngle());
    source_->SetCenter(contact.tipCenter.x(), contact.tipCenter.y(), contact.tipCenter.z());
    source_->SetParaboloidReach(style.paraboloidReach);
    source_->SetHeight(height);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    deform(shape);
    const double apex = apexOf(contact).z();
    opacity_ = {.apex = apex,
                .clear = std::min(std::max(kClearHeight * contact.tipRadius, contact.contactRadius),
                                  kMaxClear * height),
                .top = apex + height,
                .isCap = style.isCap,
                .isOpen = style.isOpen};
    paintBody(style.shading);
    showEdge(style);
    for (vtkActor* actor : {walls_[0].Get(), walls_[1].Get(), edge_.Get(), drop_.Get()}) {
        style.space.apply(actor);
        actor->VisibilityOn();
    }
    showDrop(shape);
}

void TipLayer::paintBody(const Shading& shading) {
    vtkDataArray* normals = body_->GetPointData()->GetNormals();
    const Color& color = theme::palette().tipBody;
    const auto colors = newColors(body_->GetNumberOfPoints());
    for (vtkIdType id = 0; id < body_->GetNumberOfPoints(); ++id) {
        const auto lit = shading.polished(color, Vector3(normals->GetTuple(id)));
        const unsigned char alpha = alphaOf(opacity_.at(body_->GetPoint(id)[2]));
        colors->SetTypedTuple(id, std::array{lit[0], lit[1], lit[2], alpha}.data());
    }
    body_->GetPointData()->SetScalars(colors);
}

void TipLayer::showEdge(const TipStyle& style) {
    const std::vector<Vector3> corners = seenOutline(body_, style.axes, style.space).corners;
    const auto line = polyline(corners);
    const Color& body = theme::palette().tipBody;
    const auto colors = newColors(static_cast<vtkIdType>(corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const unsigned char alpha = alphaOf(kEdgeOpacity * opacity_.fading(corners[i].z()));
        colors->SetTypedTuple(
            static_cast<vtkIdType>(i),
            std::array{shaded(body.red), shaded(body.green), shaded(body.blue), alpha}.data());
    }
    line->GetPointData()->SetScalars(colors);
    vtkPolyDataMapper::SafeDownCast(edge_->GetMapper())->SetInputData(line);
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
    const double wanted =
        isCap() ? heightScale * RoundTip{tipRadius}.height(kCapWidth * halfWidth) : headroom();
    return std::min(wanted, room);
}

double GearScale::headroom() const { return kTipTop * size(); }

bool GearScale::showsLever() const { return !isCap() && size() <= kSmallGear * halfWidth; }

void TipGear::hide() {
    tip_.hide();
    lever_.hide();
}

void TipGear::show(const Scene& scene, const ContactShape& shape, const GearScale& scale,
                   const SeenAxes& axes, const DrawnSpace& space, const Shading& shading) {
    // A tip that is pressed deep into the surface still ends above it.
    constexpr double kAboveSurface = 0.6;  // of its usual height
    const double pressed =
        (space.heightScale * shape.contact().indentation) + (kAboveSurface * scale.tipHeight());
    const double height = scale.isCap()
                              ? scale.tipHeight()
                              : std::min(std::max(scale.tipHeight(), pressed), scale.room);
    const CantileverGeometry& lever = scene.description.probe;
    const LeverPose pose{.shankTop =
                             space.point(apexOf(shape.contact())) + height * Vector3::UnitZ(),
                         .size = kLeverHalfWidth * scale.size(),
                         .azimuth = lever.azimuth,
                         .tilt = lever.mountTilt};
    const bool hasLever = scale.showsLever() &&
                          (std::isinf(scale.room) ||
                           LeverLayer::rise(pose, axes.up) <= (scale.room - height) * axes.up.z());
    tip_.show(shape, {.height = height,
                      .paraboloidReach = scale.paraboloidReach,
                      .isCap = scale.isCap(),
                      .isOpen = !hasLever,
                      .axes = axes,
                      .space = space,
                      .shading = shading});
    if (hasLever) {
        lever_.show(pose, shading);
    } else {
        lever_.hide();
    }
}

}  // namespace asperity
