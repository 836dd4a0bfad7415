#include "ui/view/GhostLayer.h"

#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kFacets = 32;
constexpr int kOutlinePoints = 48;  // of each side
constexpr double kOpacity = 0.16;
constexpr double kLineWidth = 2.0;

/// The silhouette of a tip as seen across the view: widest distance from its axis at each height.
std::vector<Vector3> outlineOf(vtkPolyData* body, const Vector3& apex, const Vector3& right,
                               double height) {
    std::vector<double> widths(kOutlinePoints + 1, 0.0);
    for (vtkIdType id = 0; id < body->GetNumberOfPoints(); ++id) {
        const Vector3 arm = Vector3(body->GetPoint(id)) - apex;
        const auto level = static_cast<std::size_t>(
            std::lround(kOutlinePoints * std::sqrt(std::clamp(arm.z() / height, 0.0, 1.0))));
        widths[level] = std::max(widths[level], arm.head<2>().norm());
    }
    std::vector<Vector3> outline;
    const auto add = [&](std::size_t level, double side) {
        const double part = static_cast<double>(level) / kOutlinePoints;
        if (level == 0 || widths[level] > 0.0) {
            outline.emplace_back(apex + side * widths[level] * right +
                                 part * part * height * Vector3::UnitZ());
        }
    };
    for (std::size_t level = kOutlinePoints; level > 0; --level) {
        add(level, -1.0);
    }
    for (std::size_t level = 0; level <= kOutlinePoints; ++level) {
        add(level, 1.0);
    }
    return outline;
}

}  // namespace

GhostLayer::GhostLayer(vtkRenderer* through) : solid_(plainSurface(body_, {})) {
    source_->SetResolution(kFacets);
    solid_->GetProperty()->LightingOff();
    solid_->GetProperty()->SetOpacity(kOpacity);
    solid_->GetProperty()->BackfaceCullingOn();
    solid_->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
    vtkNew<vtkPolyData> nothing;
    outline_ = linesAsDrawn(nothing, {}, kLineWidth);
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
    const double height = style.height / style.space.heightScale;
    source_->SetRadius(style.radius);
    source_->SetCenter(apex.x(), apex.y(), apex.z() + style.radius);
    source_->SetParaboloidReach(style.paraboloidReach);
    source_->SetHeight(height);
    source_->Update();
    body_->ShallowCopy(source_->GetOutput());
    const std::vector<Vector3> outline = outlineOf(body_, apex, style.right, height);
    vtkPolyDataMapper::SafeDownCast(outline_->GetMapper())->SetInputData(polyline(outline));
    for (vtkActor* actor : {solid_, outline_}) {
        style.space.apply(actor);
        actor->GetProperty()->SetColor(style.color.fractions().data());
        actor->VisibilityOn();
    }
    labelPlace_ = style.space.point(outline.back());
}

}  // namespace asperity
