#include "ui/view/ContactLayer.h"

#include "core/SmoothStep.h"
#include "core/scene/Scene.h"
#include "ui/view/TerrainLayer.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/module/StripGrid.h"
#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kAngles = 120;
constexpr int kCircles = 13;  // the first is the contact's middle
constexpr double kDentOpacity = 0.4;
constexpr double kRimOpacity = 0.4;
constexpr double kShadowStrength = 0.4;
constexpr double kShadowReach = 2.5;  // tip radii

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
        const Vector3 at =
            contact.closest + radius * (std::cos(angle) * across + std::sin(angle) * third);
        circle.emplace_back(at.x(), at.y(), scene.surface.at(at.x(), at.y()).height);
    }
    return circle;
}

void setData(vtkActor* actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(data);
    actor->VisibilityOn();
}

/// The sample before and the one after, along a line of a grid.
struct Neighbors {
    std::size_t before;
    std::size_t after;
};

Neighbors neighbors(int along, int count, std::size_t index, std::size_t stride) {
    return {along > 0 ? index - stride : index, along + 1 < count ? index + stride : index};
}

/// The surface's own normal at rest, turned by the slopes of the displacement.
Vector3 deformedNormal(const ContactShape& shape, int row, int column) {
    const SurfacePatch& patch = shape.patch();
    const std::vector<double>& pushed = shape.displacements();
    const std::size_t i = patch.index(row, column);
    const Neighbors x = neighbors(column, patch.columns, i, 1);
    const Neighbors y = neighbors(row, patch.rows, i, patch.index(1, 0));
    const double slopeX = -(pushed[x.after] - pushed[x.before]) /
                          (patch.rest[x.after].x() - patch.rest[x.before].x());
    const double slopeY = -(pushed[y.after] - pushed[y.before]) /
                          (patch.rest[y.after].y() - patch.rest[y.before].y());
    const Vector3 rest = patch.normals[i] / patch.normals[i].z();
    const Vector3 alongX(1.0, 0.0, -rest.x());
    const Vector3 alongY(0.0, 1.0, -rest.y());
    const Vector3& axis = shape.outward();
    return (rest + slopeX * axis.cross(alongY) + slopeY * alongX.cross(axis)).normalized();
}

struct Range {
    double low;
    double high;
};

/// Multiples of the spacing, and those ends of the area at which the terrain ends.
std::vector<double> linePositions(const Range& area, const Range& window, double spacing) {
    std::vector<double> positions = gridPositions(area.low, area.high, spacing);
    if (area.low == window.low) {
        positions.push_back(area.low);
    }
    if (area.high == window.high) {
        positions.push_back(area.high);
    }
    return positions;
}

/// Distance from a position to the nearest side of the patch at which the terrain goes on, at most
/// `reach`.
double distanceToTerrain(const Vector3& from, const ContactStyle& style, double reach) {
    const ScanWindow& area = style.gridArea;
    const ScanWindow& window = style.window;
    const auto shorten = [&reach](double side, double end, double at) {
        reach = side == end ? reach : std::min(reach, std::abs(side - at));
    };
    shorten(area.left, window.left, from.x());
    shorten(area.right, window.right, from.x());
    shorten(area.bottom, window.bottom, from.y());
    shorten(area.top, window.top, from.y());
    return reach;
}

/// The tip's soft shadow: the share of the light from all around that its ball keeps from the
/// surface. It ends where the patch does. There is none in the contact and on what the tip has
/// moved: colors are read there.
class ContactShadow {
public:
    ContactShadow(const TipContact& contact, const ContactStyle& style)
        : contact_(contact)
        , reach_(distanceToTerrain(contact.closest, style, kShadowReach * contact.tipRadius)) {}

    /// Brightness that is left at a position, 0 .. 1. @param normal of the surface there
    [[nodiscard]] double at(const Vector3& position, const Vector3& normal) const {
        const Vector3 away = position - contact_.closest;
        const double fromAxis = (away - away.dot(contact_.normal) * contact_.normal).norm();
        if (fromAxis < contact_.contactRadius) {
            return 1.0;
        }
        const Vector3 toBall = contact_.tipCenter - position;
        const double facing = std::max(0.0, normal.dot(toBall.stableNormalized()));
        const double seen = contact_.tipRadius / toBall.stableNorm();
        const double fading = 1.0 - smoothStep(fromAxis / reach_);
        return 1.0 - kShadowStrength * fading * facing * std::min(1.0, seen * seen);
    }

private:
    const TipContact& contact_;
    double reach_;  ///< [m]
};

std::array<unsigned char, 3> darkened(std::array<unsigned char, 3> color, double light) {
    for (unsigned char& part : color) {
        part = static_cast<unsigned char>(std::lround(light * part));
    }
    return color;
}

}  // namespace

std::vector<Vector3> circleInContact(const Scene& scene, const ContactShape& shape, double radius) {
    std::vector<Vector3> circle = circleAtRest(scene, shape.contact(), radius);
    for (Vector3& position : circle) {
        position = shape.moved(position);
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
            const Vector3 position = shape.moved(rest);
            points_->InsertNextPoint(position.data());
            const double pushed = (rest - position).dot(contact.normal);
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

ContactLayer::ContactLayer(vtkRenderer* solid, vtkRenderer* through) : hidden_(through) {
    points_->SetDataTypeToDouble();
    rgb_->SetNumberOfComponents(3);
    mesh_->SetPoints(points_);
    mesh_->GetPointData()->SetScalars(rgb_);
    surface_ = surfaceAsColored(mesh_);
    vtkNew<vtkPolyData> nothing;
    grid_ = thinLines(nothing);
    rim_ = linesAsDrawn(nothing, palette::kContact, 2.0);
    walls_ = surfaceAsColored(nothing);
    solid->AddActor(surface_);
    solid->AddActor(walls_);
    solid->AddActor(grid_);
    solid->AddActor(rim_);
    hide();
}

ContactLayer::~ContactLayer() = default;

void ContactLayer::hide() {
    surface_->VisibilityOff();
    walls_->VisibilityOff();
    grid_->VisibilityOff();
    rim_->VisibilityOff();
    hidden_.hide();
}

void ContactLayer::show(const Scene& scene, const ContactShape& shape, const ContactStyle& style) {
    fitSize(shape.patch());
    showSurface(shape, style);
    showWalls(style);
    showGrid(scene, shape, style);
    showRim(scene, shape, style);
    for (vtkActor* actor : {surface_, walls_, grid_, rim_}) {
        style.space.apply(actor);
    }
}

void ContactLayer::fitSize(const SurfacePatch& patch) {
    if (patch.columns == samples_) {
        return;
    }
    samples_ = patch.columns;
    const auto count = static_cast<vtkIdType>(patch.rest.size());
    points_->SetNumberOfPoints(count);
    rgb_->SetNumberOfTuples(count);
    mesh_->SetStrips(gridStrips(patch.columns, patch.rows));
}

void ContactLayer::showSurface(const ContactShape& shape, const ContactStyle& style) {
    const SurfacePatch& patch = shape.patch();
    const ContactShadow shadow(shape.contact(), style);
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const std::size_t i = patch.index(row, column);
            const auto id = static_cast<vtkIdType>(i);
            points_->SetPoint(id, patch.points[i].data());
            const Vector3 normal = deformedNormal(shape, row, column);
            const double light = style.hasShadow ? std::lerp(shadow.at(patch.points[i], normal),
                                                             1.0, style.colors.movedShare(i))
                                                 : 1.0;
            rgb_->SetTypedTuple(
                id, darkened(style.shading.litSurface(style.colors.of(i), normal), light).data());
        }
    }
    points_->Modified();
    rgb_->Modified();
    surface_->VisibilityOn();
}

/// From the drawn surface down, on the sides where the terrain ends and has no walls of its own.
void ContactLayer::showWalls(const ContactStyle& style) {
    const ScanWindow& area = style.gridArea;
    const ScanWindow& window = style.window;
    const auto sides = blockSides(mesh_, {samples_, samples_}, style.bottom,
                                  {.front = area.bottom == window.bottom,
                                   .back = area.top == window.top,
                                   .left = area.left == window.left,
                                   .right = area.right == window.right});
    paint(sides, theme::palette().side, style.shading, kWallMatt);
    sides->GetPointData()->SetNormals(nullptr);  // they are lit already
    setData(walls_, sides);
}

void ContactLayer::showGrid(const Scene& scene, const ContactShape& shape,
                            const ContactStyle& style) {
    if (!(style.gridSpacing > 0.0)) {
        grid_->VisibilityOff();
        return;
    }
    const SurfacePatch& patch = shape.patch();
    const ScanWindow& area = style.gridArea;
    const ScanWindow& window = style.window;
    const auto drawn = [&](double x, double y) {
        const double inX = std::clamp(x, area.left, area.right);
        const double inY = std::clamp(y, area.bottom, area.top);
        return shape.moved({inX, inY, scene.surface.at(inX, inY).height});
    };
    Polylines grid;
    // The patch has as many rows as columns.
    std::vector<Vector3> line(static_cast<std::size_t>(patch.columns));
    for (const double x :
         linePositions({area.left, area.right}, {window.left, window.right}, style.gridSpacing)) {
        for (std::size_t row = 0; row < line.size(); ++row) {
            line[row] = drawn(x, patch.rest[row * line.size()].y());
        }
        grid.add(line);
    }
    for (const double y :
         linePositions({area.bottom, area.top}, {window.bottom, window.top}, style.gridSpacing)) {
        for (std::size_t column = 0; column < line.size(); ++column) {
            line[column] = drawn(patch.rest[column].x(), y);
        }
        grid.add(line);
    }
    setData(grid_, grid.data());
}

void ContactLayer::showRim(const Scene& scene, const ContactShape& shape,
                           const ContactStyle& style) {
    const TipContact& contact = shape.contact();
    if (!(contact.contactRadius > 0.0)) {
        rim_->VisibilityOff();
        hidden_.hide();
        return;
    }
    const auto line = polyline(circleInContact(scene, shape, contact.contactRadius));
    setData(rim_, line);
    hidden_.hide();
    hidden_.showRim(line, style.space);
    if (!style.isCut) {
        hidden_.showDent(scene, shape, style.colors, style.space);
    }
}

}  // namespace asperity
