#include "vtkplugins/pictures/RestingPatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// Cell of a rising axis and the position within it; beyond the ends the ends.
struct AxisPosition {
    std::size_t cell = 0;
    double part = 0.0;
};

AxisPosition locate(const std::vector<double>& axis, double value) {
    const auto after = std::upper_bound(axis.begin() + 1, axis.end() - 1, value);
    const auto cell = static_cast<std::size_t>(after - axis.begin()) - 1;
    return {cell, std::clamp((value - axis[cell]) / (axis[cell + 1] - axis[cell]), 0.0, 1.0)};
}

constexpr int kPoints = 180;
constexpr int kBlurred = 4;       ///< points on either side: about two samples of the patch
constexpr double kMaxStep = 3.0;  ///< between points, in steps of a flat circle

/// The surface at rest around the circle, and how far it has moved outwards there.
struct MovedPoint {
    Vector3 rest;
    double moved = 0.0;  ///< [m]
};

std::vector<MovedPoint> aroundContact(const SurfacePatch& patch, const ContactEdge& edge) {
    const RestingPatch resting(patch);
    const Vector3 across = edge.outward.unitOrthogonal();
    const Vector3 third = edge.outward.cross(across);
    std::vector<MovedPoint> around;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        const Vector3 arm = std::cos(angle) * across + std::sin(angle) * third;
        const Vector3 rest = resting.closest(edge.center + edge.radius * arm, edge.outward);
        const Vector3 point = resting.at(patch.points, rest.x(), rest.y());
        around.push_back({rest, (point - rest).dot(edge.outward)});
    }
    return around;
}

/// A mean along the circle: between the samples of a sharp rim the patch alone is ragged.
double smoothMove(const std::vector<MovedPoint>& around, int index) {
    double sum = 0.0;
    for (int i = index - kBlurred; i <= index + kBlurred; ++i) {
        sum += around[static_cast<std::size_t>((i + kPoints) % kPoints)].moved;
    }
    return sum / (2 * kBlurred + 1);
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
    const AxisPosition column = locate(x_, x);
    const AxisPosition row = locate(y_, y);
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
    Vector3 position = point;
    double above = 1.0;
    for (int step = 0; step < kSteps && std::abs(above) > kNothing; ++step) {
        above = position.z() - at(rest_, position.x(), position.y()).z();
        position -= above * direction.z() * direction;
    }
    return position;
}

std::vector<std::vector<Vector3>> contactCircle(const SurfacePatch& patch,
                                                const ContactEdge& edge) {
    const std::vector<MovedPoint> around = aroundContact(patch, edge);
    const double longest = kMaxStep * 2.0 * std::numbers::pi * edge.radius / kPoints;
    std::vector<std::vector<Vector3>> pieces(1);
    for (int i = 0; i <= kPoints; ++i) {
        const Vector3 point = around[static_cast<std::size_t>(i % kPoints)].rest +
                              smoothMove(around, i % kPoints) * edge.outward;
        if (!pieces.back().empty() && (point - pieces.back().back()).norm() > longest) {
            pieces.emplace_back();
        }
        pieces.back().push_back(point);
    }
    return pieces;
}

}  // namespace asperity
