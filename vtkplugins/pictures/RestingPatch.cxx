#include "vtkplugins/pictures/RestingPatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

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

}  // namespace asperity
