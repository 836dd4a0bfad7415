#include "ui/view/GhostLayer.h"

#include "ui/widgets/Theme.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QObject>

namespace asperity {

namespace {

constexpr int kGhostFacets = 32;
constexpr double kGhostOpacity = 0.16;
constexpr double kGhostLineWidth = 2.0;

/// By which a ghost is drawn before what is of lower rank, in VTK's units of depth: more than the
/// depth of all that is drawn.
constexpr double kRankOffset = -12000.0;

}  // namespace

GhostLayer::GhostLayer(vtkRenderer* through, int rank) : solid_(plainSurface(body_, {})) {
    source_->SetResolution(kGhostFacets);
    solid_->GetProperty()->LightingOff();
    solid_->GetProperty()->SetOpacity(kGhostOpacity);
    solid_->GetProperty()->BackfaceCullingOn();
    solid_->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
    vtkNew<vtkPolyData> nothing;
    outline_ = linesAsDrawn(nothing, {}, kGhostLineWidth);
    const double offset = rank * kRankOffset;
    solid_->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, offset);
    outline_->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, 1.01 * offset);
    through->AddActor(solid_);
    through->AddActor(outline_);
    hide();
}

GhostLayer::~GhostLayer() = default;

void GhostLayer::hide() {
    solid_->VisibilityOff();
    outline_->VisibilityOff();
}

void GhostLayer::show(const Vector3& apex, double height, const GhostStyle& style,
                      const Color& color) {
    source_->SetRadius(style.radius);
    source_->SetHalfAngle(style.shankHalfAngle);
    source_->SetCenter(apex.x(), apex.y(), apex.z() + style.radius);
    source_->SetParaboloidReach(style.paraboloidReach);
    source_->SetHeight(height / style.space.heightScale);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    const SeenOutline outline = seenOutline(body_, style.axes, style.space);
    vtkPolyDataMapper::SafeDownCast(outline_->GetMapper())->SetInputData(polyline(outline.corners));
    for (vtkActor* actor : {solid_, outline_}) {
        style.space.apply(actor);
        actor->GetProperty()->SetColor(color.fractions().data());
        actor->VisibilityOn();
    }
    labelPosition_ = style.space.point(outline.rightEnd);
}

void TipGhosts::show(const std::optional<Pose>& commanded, const std::optional<Pose>& trueTip,
                     const GhostStyle& style) {
    names_.clear();
    const auto show = [&](GhostLayer& ghost, const std::optional<Pose>& pose, const Color& color,
                          const QString& name) {
        if (!pose || !pose->apex.allFinite()) {
            ghost.hide();
            return;
        }
        ghost.show(pose->apex, pose->height, style, color);
        names_.push_back({ghost.labelPosition(), name.toStdString(), color});
    };
    show(commanded_, commanded, theme::palette().commanded, QObject::tr("commanded"));
    show(true_, trueTip, theme::palette().trueTip, QObject::tr("true tip"));
}

}  // namespace asperity
