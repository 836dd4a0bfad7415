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

#include <algorithm>
#include <iterator>
#include <utility>

namespace asperity {

namespace {

constexpr int kGhostFacets = 32;
constexpr double kGhostOpacity = 0.16;
constexpr double kGhostLineWidth = 2.0;

/// A point of the body as it is seen.
struct SeenPoint {
    Vector2 seen;  ///< rightwards, upwards
    Vector3 world;
};

/// Returns whether the way from `a` over `b` to `c` turns right or goes straight on.
bool isNoLeftTurn(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c) {
    const Vector2 first = b.seen - a.seen;
    const Vector2 second = c.seen - a.seen;
    return first.x() * second.y() - first.y() * second.x() <= 0.0;
}

/// Half of the convex hull of points in their order, its ends included.
std::vector<SeenPoint> hullChain(const std::vector<SeenPoint>& points) {
    std::vector<SeenPoint> chain;
    for (const SeenPoint& point : points) {
        while (chain.size() > 1 && isNoLeftTurn(chain.end()[-2], chain.back(), point)) {
            chain.pop_back();
        }
        chain.push_back(point);
    }
    return chain;
}

/// The outline of a tip as it is seen, closed: tips are convex. It begins at the left end, goes
/// below to the right one, and back above. Andrew (1979), Another efficient algorithm for convex
/// hulls in two dimensions.
struct Outline {
    std::vector<Vector3> corners;
    Vector3 rightEnd;
};

Outline outlineOf(vtkPolyData* body, const GhostStyle& style) {
    std::vector<SeenPoint> points;
    for (vtkIdType id = 0; id < body->GetNumberOfPoints(); ++id) {
        const Vector3 position(body->GetPoint(id));
        const Vector3 drawn = style.space.point(position);
        points.push_back({{style.right.dot(drawn), style.up.dot(drawn)}, position});
    }
    std::ranges::sort(points, {}, [](const SeenPoint& point) {
        return std::pair(point.seen.x(), point.seen.y());
    });
    std::vector<Vector3> corners;
    const Vector3 rightEnd = points.back().world;
    for (int half = 0; half < 2; ++half) {
        std::ranges::transform(hullChain(points), std::back_inserter(corners), &SeenPoint::world);
        std::ranges::reverse(points);
    }
    return {corners, rightEnd};
}

}  // namespace

GhostLayer::GhostLayer(vtkRenderer* through) : solid_(plainSurface(body_, {})) {
    source_->SetResolution(kGhostFacets);
    solid_->GetProperty()->LightingOff();
    solid_->GetProperty()->SetOpacity(kGhostOpacity);
    solid_->GetProperty()->BackfaceCullingOn();
    solid_->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
    vtkNew<vtkPolyData> nothing;
    outline_ = linesAsDrawn(nothing, {}, kGhostLineWidth);
    through->AddActor(solid_);
    through->AddActor(outline_);
    hide();
}

GhostLayer::~GhostLayer() = default;

void GhostLayer::hide() {
    solid_->VisibilityOff();
    outline_->VisibilityOff();
}

void GhostLayer::show(const Vector3& apex, const GhostStyle& style) {
    source_->SetRadius(style.radius);
    source_->SetHalfAngle(style.shankHalfAngle);
    source_->SetCenter(apex.x(), apex.y(), apex.z() + style.radius);
    source_->SetParaboloidReach(style.paraboloidReach);
    source_->SetHeight(style.height / style.space.heightScale);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    const Outline outline = outlineOf(body_, style);
    vtkPolyDataMapper::SafeDownCast(outline_->GetMapper())->SetInputData(polyline(outline.corners));
    for (vtkActor* actor : {solid_, outline_}) {
        style.space.apply(actor);
        actor->GetProperty()->SetColor(style.color.fractions().data());
        actor->VisibilityOn();
    }
    labelPosition_ = style.space.point(outline.rightEnd);
}

void TipGhosts::show(const ViewOptions& options, const std::optional<Vector3>& commanded,
                     const std::optional<Vector3>& trueTip, GhostStyle style) {
    names_.clear();
    const auto show = [&](GhostLayer& ghost, bool isOn, const std::optional<Vector3>& apex,
                          const Color& color, const QString& name) {
        if (!isOn || !apex || !apex->allFinite()) {
            ghost.hide();
            return;
        }
        style.color = color;
        ghost.show(*apex, style);
        names_.push_back({ghost.labelPosition(), name.toStdString(), color});
    };
    show(commanded_, options.commandedTip, commanded, theme::palette().commanded,
         QObject::tr("commanded"));
    show(true_, options.trueTip, trueTip, theme::palette().trueTip, QObject::tr("true tip"));
}

}  // namespace asperity
