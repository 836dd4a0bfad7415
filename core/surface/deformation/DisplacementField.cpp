#include "core/surface/deformation/DisplacementField.h"

#include "core/Error.h"
#include "core/surface/BezierCell.h"
#include "core/surface/closest/BoxNewton.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

CubicSpan spanOf(const SplinePatch::Axis& axis, double position) {
    return cubicSpan((position - axis.low()) / axis.spacing, axis.count - 3);
}

Vector3 weighted(const SplinePatch& patch, const CubicSpan& across, const CubicSpan& up,
                 const std::pair<Eigen::Vector4d, Eigen::Vector4d>& weights) {
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            sum += weights.first[i] * weights.second[j] *
                   patch.controls[patch.index(up.first + j, across.first + i)];
        }
    }
    return sum;
}

/// Number of control points of a net with the spans from `low` to `high` halved.
std::size_t countAfterHalving(const SplinePatch::Axis& halved, const SplinePatch::Axis& other) {
    return static_cast<std::size_t>(2 * halved.count - 3) * static_cast<std::size_t>(other.count);
}

/// Exchanges the roles of x and y in the order of the control points.
SplinePatch transposed(const SplinePatch& patch) {
    SplinePatch result{.x = patch.y, .y = patch.x, .controls = {}};
    result.controls.reserve(patch.controls.size());
    for (int column = 0; column < patch.x.count; ++column) {
        for (int row = 0; row < patch.y.count; ++row) {
            result.controls.push_back(patch.controls[patch.index(row, column)]);
        }
    }
    return result;
}

/// The same surface with half the spacing between its rows: every second control point lies between
/// two old ones, the others are drawn towards their neighbors.
SplinePatch withRowsHalved(const SplinePatch& patch) {
    SplinePatch result = patch;
    result.y.count = 2 * patch.y.count - 3;
    result.y.spacing = 0.5 * patch.y.spacing;
    result.y.first = patch.y.first + result.y.spacing;
    result.controls.resize(result.index(result.y.count, 0));
    for (int row = 0; row < result.y.count; ++row) {
        const int below = row / 2;
        for (int column = 0; column < patch.x.count; ++column) {
            const Vector3& a = patch.controls[patch.index(below, column)];
            const Vector3& b = patch.controls[patch.index(below + 1, column)];
            Vector3& target = result.controls[result.index(row, column)];
            if (row % 2 == 0) {
                target = 0.5 * (a + b);
            } else {
                target = 0.125 * (a + patch.controls[patch.index(below + 2, column)]) + 0.75 * b;
            }
        }
    }
    return result;
}

/// Drops the rows that do not shape low..high.
SplinePatch withRowsCropped(SplinePatch patch, double low, double high) {
    const int first = spanOf(patch.y, low).first;
    const int last = spanOf(patch.y, high).first + 3;
    const auto begin = patch.controls.begin();
    std::vector<Vector3> kept(begin + static_cast<std::ptrdiff_t>(patch.index(first, 0)),
                              begin + static_cast<std::ptrdiff_t>(patch.index(last + 1, 0)));
    patch.controls = std::move(kept);
    patch.y.first += first * patch.y.spacing;
    patch.y.count = last - first + 1;
    return patch;
}

SplinePatch withRowsRefined(SplinePatch patch, std::pair<double, double> range, double spacing) {
    while (patch.y.spacing > spacing && countAfterHalving(patch.y, patch.x) <= kMaxPatchControls) {
        patch = withRowsCropped(withRowsHalved(patch), range.first, range.second);
    }
    return patch;
}

/// The spans of one axis of the surface that cover low..high.
SplinePatch::Axis axisOver(double low, double high, double pitch) {
    const double firstCell = std::floor(low / pitch - 0.5);
    const double lastCell = std::floor(high / pitch - 0.5);
    return {.count = static_cast<int>(lastCell - firstCell) + 4,
            .first = (firstCell - 0.5) * pitch,
            .spacing = pitch};
}

SplinePatch netOf(const BSplineSurface& surface, const Box& window) {
    const BSplineSurface::Grid& grid = surface.grid();
    SplinePatch patch{.x = axisOver(window.low.x(), window.high.x(), grid.pitchX),
                      .y = axisOver(window.low.y(), window.high.y(), grid.pitchY),
                      .controls = {}};
    const std::size_t count = patch.index(patch.y.count, 0);
    if (count > kMaxPatchControls) {
        throw Error("the window to be refined holds too many pixels of the scan");
    }
    patch.controls.reserve(count);
    const int firstColumn = static_cast<int>(std::lround(patch.x.first / grid.pitchX - 0.5));
    const int firstRow = static_cast<int>(std::lround(patch.y.first / grid.pitchY - 0.5));
    for (int row = 0; row < patch.y.count; ++row) {
        for (int column = 0; column < patch.x.count; ++column) {
            patch.controls.emplace_back((firstColumn + column + 0.5) * grid.pitchX,
                                        (firstRow + row + 0.5) * grid.pitchY,
                                        surface.control(firstRow + row, firstColumn + column));
        }
    }
    return patch;
}

/// The control point before `position`; it and the next one are the two nearest along the axis.
int controlBefore(const SplinePatch::Axis& axis, double position) {
    const int before = static_cast<int>(std::floor((position - axis.first) / axis.spacing));
    return std::clamp(before, 0, axis.count - 2);
}

constexpr double kControlsPerRadius = 8.0;

/// From a point near the contact's axis, along that axis, to the side of the tip that faces the
/// sample.
Vector3 ontoTip(const TipContact& contact, const Vector3& point) {
    const RoundTip tip = contact.tip();
    const double fromAxis = std::min(distanceFromAxis(contact, point), tip.reach());
    const double drop = tip.hasCone()
                            ? tip.radius - tip.height(fromAxis)
                            : std::sqrt((tip.radius - fromAxis) * (tip.radius + fromAxis));
    const double above = (point - contact.tipCenter).dot(contact.normal);
    return -(above + drop) * contact.normal;
}

/// 1 inside `reach` of the contact's axis, 0 outside, and in between across one spacing: without it
/// the rows and columns of the net would show as teeth of the rim.
double partInside(const TipContact& contact, const Vector3& point, double reach, double spacing) {
    return std::clamp((reach - distanceFromAxis(contact, point)) / spacing + 0.5, 0.0, 1.0);
}

}  // namespace

Vector3 SplinePatch::point(double restX, double restY) const {
    const CubicSpan across = spanOf(x, restX);
    const CubicSpan up = spanOf(y, restY);
    return weighted(*this, across, up, {across.value, up.value});
}

Vector3 SplinePatch::normal(double restX, double restY) const {
    const CubicSpan across = spanOf(x, restX);
    const CubicSpan up = spanOf(y, restY);
    const Vector3 alongX = weighted(*this, across, up, {across.slope, up.value}) / x.spacing;
    const Vector3 alongY = weighted(*this, across, up, {across.value, up.slope}) / y.spacing;
    return alongX.cross(alongY).normalized();
}

SplinePatch refined(const BSplineSurface& surface, const Box& window, double spacing) {
    if (!std::isgreater(spacing, 0.0)) {
        throw Error("the spacing must be a positive length");
    }
    if (!window.low.allFinite() || !window.high.allFinite()) {
        throw Error("the window to be refined must be finite");
    }
    const Box scan = scanBox(surface);
    const Vector2 low = scan.nearest(window.low.cwiseMin(window.high));
    const Vector2 high = scan.nearest(window.high.cwiseMax(window.low));
    SplinePatch patch = netOf(surface, {.low = low, .high = high});
    patch = withRowsRefined(std::move(patch), {low.y(), high.y()}, spacing);
    patch = withRowsRefined(transposed(patch), {low.x(), high.x()}, spacing);
    return transposed(patch);
}

SplinePatch netAroundContact(const BSplineSurface& surface, const TipContact& contact,
                             double spacing) {
    // A slope stretches the net along the surface; past this much the picture gains nothing.
    constexpr double kMinNormalZ = 0.1;
    const double flatness = std::max(contact.normal.z(), kMinNormalZ);
    const Vector2 closest = contact.closest.head<2>();
    const Vector2 reach = Vector2::Constant(contact.contactRadius + 3.0 * spacing);
    return refined(surface, {.low = closest - reach, .high = closest + reach}, spacing * flatness);
}

DisplacementField fieldOf(SplinePatch displacements) {
    return [net = std::move(displacements)](const Vector3& rest) -> Vector3 {
        if (!net.contains(rest.x(), rest.y())) {
            return Vector3::Zero();
        }
        return net.point(rest.x(), rest.y());
    };
}

double distanceFromAxis(const TipContact& contact, const Vector3& point) {
    const Vector3 arm = point - contact.closest;
    return (arm - arm.dot(contact.normal) * contact.normal).norm();
}

DisplacementField closedFormField(const TipContact& contact, RadialDisplacement displacement) {
    return [contact, u = std::move(displacement)](const Vector3& rest) -> Vector3 {
        return -u(distanceFromAxis(contact, rest)) * contact.normal;
    };
}

DisplacementField fourPointField(const BSplineSurface& surface, const TipContact& contact) {
    SplinePatch net = netAroundContact(surface, contact, contact.contactRadius);
    const int column = controlBefore(net.x, contact.closest.x());
    const int row = controlBefore(net.y, contact.closest.y());
    std::fill(net.controls.begin(), net.controls.end(), Vector3::Zero());
    for (const int j : {row, row + 1}) {
        for (const int i : {column, column + 1}) {
            net.controls[net.index(j, i)] = -contact.indentation * contact.normal;
        }
    }
    return fieldOf(std::move(net));
}

DisplacementField contactRadiusField(const BSplineSurface& surface, const TipContact& contact) {
    const double spacing = contact.contactRadius / kControlsPerRadius;
    SplinePatch net = netAroundContact(surface, contact, spacing);
    // A contact wider than a sphere has nothing to lie on beyond the sphere's own radius.
    const double reach = std::min(contact.contactRadius, contact.tip().reach());
    for (Vector3& control : net.controls) {
        control = partInside(contact, control, reach, spacing) * ontoTip(contact, control);
    }
    return fieldOf(std::move(net));
}

}  // namespace asperity
