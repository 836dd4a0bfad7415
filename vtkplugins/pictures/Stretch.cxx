#include "vtkplugins/pictures/Stretch.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// Cell of a rising axis and the place within it; beyond the ends the ends.
struct AxisPlace {
    std::size_t cell = 0;
    double part = 0.0;
};

AxisPlace locate(const std::vector<double>& axis, double value) {
    const auto after = std::upper_bound(axis.begin() + 1, axis.end() - 1, value);
    const auto cell = static_cast<std::size_t>(after - axis.begin()) - 1;
    return {cell, std::clamp((value - axis[cell]) / (axis[cell + 1] - axis[cell]), 0.0, 1.0)};
}

/// Unit normal of a grid of points at one of them, by central differences.
Vector3 gridNormal(const SurfacePatch& patch, const std::vector<Vector3>& points, int row,
                   int column) {
    const int left = std::max(column - 1, 0);
    const int right = std::min(column + 1, patch.columns - 1);
    const int lower = std::max(row - 1, 0);
    const int upper = std::min(row + 1, patch.rows - 1);
    const Vector3 alongX = points[patch.index(row, right)] - points[patch.index(row, left)];
    const Vector3 alongY = points[patch.index(upper, column)] - points[patch.index(lower, column)];
    return alongX.stableNormalized().cross(alongY.stableNormalized()).normalized();
}

}  // namespace

RestingPatch::RestingPatch(const SurfacePatch& patch) : rest_(patch.rest) {
    for (int column = 0; column < patch.columns; ++column) {
        x_.push_back(patch.rest[patch.index(0, column)].x());
    }
    for (int row = 0; row < patch.rows; ++row) {
        y_.push_back(patch.rest[patch.index(row, 0)].y());
    }
}

Vector3 RestingPatch::at(const std::vector<Vector3>& field, double x, double y) const {
    const AxisPlace column = locate(x_, x);
    const AxisPlace row = locate(y_, y);
    const std::size_t lower = row.cell * x_.size() + column.cell;
    const std::size_t upper = lower + x_.size();
    const Vector3 below = (1.0 - column.part) * field[lower] + column.part * field[lower + 1];
    const Vector3 above = (1.0 - column.part) * field[upper] + column.part * field[upper + 1];
    return (1.0 - row.part) * below + row.part * above;
}

Vector3 RestingPatch::normal(double x, double y) const {
    const double stepX = x_[1] - x_[0];
    const double stepY = y_[1] - y_[0];
    const double inX = std::clamp(x, x_.front(), x_.back());
    const double inY = std::clamp(y, y_.front(), y_.back());
    const Vector3 alongX = at(rest_, inX + stepX, inY) - at(rest_, inX - stepX, inY);
    const Vector3 alongY = at(rest_, inX, inY + stepY) - at(rest_, inX, inY - stepY);
    return alongX.stableNormalized().cross(alongY.stableNormalized()).normalized();
}

Vector3 RestingPatch::closest(const Vector3& point, const Vector3& direction) const {
    // Each step moves along the line by the height that is left; it shrinks with the surface's
    // slope against the plane normal to the line, which is small around a contact.
    constexpr int kSteps = 12;
    constexpr double kNothing = 1e-16;  // [m]
    Vector3 place = point;
    double above = 1.0;
    for (int step = 0; step < kSteps && std::abs(above) > kNothing; ++step) {
        above = place.z() - at(rest_, place.x(), place.y()).z();
        place -= above * direction.z() * direction;
    }
    return place;
}

Stretch::Stretch(const SurfacePatch& patch, Vector3 direction, double factor)
    : resting_(patch), direction_(std::move(direction)), factor_(factor) {}

Vector3 Stretch::point(const Vector3& point) const {
    const Vector3 closest = resting_.closest(point, direction_);
    return closest + factor_ * (point - closest);
}

Vector3 Stretch::normal(const Vector3& point, const Vector3& normal) const {
    return normalAbove(resting_.closest(point, direction_), normal);
}

Vector3 Stretch::normalAbove(const Vector3& closest, const Vector3& normal) const {
    // The inverse transpose of the stretch's Jacobian, the resting surface taken as its tangent
    // plane at the closest point.
    const Vector3 rest = resting_.normal(closest.x(), closest.y());
    const double share = (factor_ - 1.0) / factor_ * normal.dot(direction_) / rest.dot(direction_);
    return (normal - share * rest).normalized();
}

vtkSmartPointer<vtkPolyData> Stretch::apply(vtkPolyData* data) const {
    auto stretched = vtkSmartPointer<vtkPolyData>::New();
    stretched->ShallowCopy(data);
    const vtkIdType count = data->GetNumberOfPoints();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkDataArray* oldNormals = data->GetPointData()->GetNormals();
    for (vtkIdType id = 0; id < count; ++id) {
        const Vector3 place(data->GetPoint(id));
        const Vector3 closest = resting_.closest(place, direction_);
        points->SetPoint(id, Vector3(closest + factor_ * (place - closest)).data());
        if (oldNormals != nullptr) {
            normals->SetTuple(id, normalAbove(closest, Vector3(oldNormals->GetTuple(id))).data());
        }
    }
    stretched->SetPoints(points);
    if (oldNormals != nullptr) {
        stretched->GetPointData()->SetNormals(normals);
    }
    return stretched;
}

vtkSmartPointer<vtkPolyData> stretchedSurface(const SurfacePatch& patch, double factor,
                                              vtkPolyData* surface) {
    std::vector<Vector3> shown(patch.points.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(shown.size()));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i] = patch.rest[i] + factor * (patch.points[i] - patch.rest[i]);
        points->SetPoint(static_cast<vtkIdType>(i), shown[i].data());
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(points->GetNumberOfPoints());
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            normals->SetTuple(static_cast<vtkIdType>(patch.index(row, column)),
                              gridNormal(patch, shown, row, column).data());
        }
    }
    auto stretched = vtkSmartPointer<vtkPolyData>::New();
    stretched->ShallowCopy(surface);
    stretched->SetPoints(points);
    stretched->GetPointData()->SetNormals(normals);
    return stretched;
}

}  // namespace asperity
