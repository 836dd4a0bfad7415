#include "ui/view/ContactShape.h"

#include "core/SmoothStep.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/DisplacementField.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Part of the room around the contact over which the displacement goes over into rest.
constexpr double kBlend = 0.35;

/// In contact radii: a narrower rectangle begins to cut the contact's rim, and shows less of it.
constexpr double kRoomForContact = 1.6;

/// Samples at the border lie cosh(k) times as far apart as at the contact.
constexpr double kCrowding = 4.0;

/// A middle so close to an end that the samples between would lie on top of each other, part of the
/// length.
constexpr double kAtTheEnd = 1e-3;

/// Positions from `low` to `high`, crowded about `middle`: one of them for odd counts, or an end.
std::vector<double> crowded(double low, double middle, double high, int count) {
    const double close = kAtTheEnd * (high - low);
    const double first = middle - low < close ? 0.0 : -1.0;
    const double last = high - middle < close ? 0.0 : 1.0;
    std::vector<double> positions;
    for (int i = 0; i < count; ++i) {
        const double part = std::lerp(first, last, i / (count - 1.0));
        const double away = std::sinh(kCrowding * std::abs(part)) / std::sinh(kCrowding);
        positions.push_back(std::lerp(middle, part < 0.0 ? low : high, away));
    }
    return positions;
}

/// The rectangle, with the sides on the scan's edge pushed out of reach.
ScanWindow withoutScanEdges(const ScanWindow& area, const BSplineSurface& surface) {
    const auto pushed = [](double side, double edge, double size, double direction) {
        constexpr double kRounding = 1e-9;
        const bool isOnEdge = std::abs(side - edge) <= kRounding * size;
        return isOnEdge ? direction * std::numeric_limits<double>::infinity() : side;
    };
    const double x = surface.sizeX();
    const double y = surface.sizeY();
    return {.left = pushed(area.left, 0.0, x, -1.0),
            .right = pushed(area.right, x, x, 1.0),
            .bottom = pushed(area.bottom, 0.0, y, -1.0),
            .top = pushed(area.top, y, y, 1.0)};
}

/// Half the length of a side, or what there is of it on one side of the contact; without end where
/// the side has none.
double roomAlong(double low, double middle, double high) {
    const bool isWhole = std::isfinite(low) && std::isfinite(high);
    return isWhole ? 0.5 * (high - low) : std::min(middle - low, high - middle);
}

}  // namespace

TipState atRest(TipState state) {
    constexpr double kFarOff = -1.0;  // [m]
    state.contact = {.indentation = kFarOff};
    return state;
}

bool isDrawable(const TipState& state) {
    const ContactState& contact = state.contact;
    return state.tip.allFinite() && state.closest.point.allFinite() &&
           state.closest.normal.allFinite() && std::isfinite(contact.contactRadius) &&
           std::isfinite(contact.indentation) && std::isfinite(contact.force);
}

ContactShape::ContactShape(const Scene& scene, const TipState& state, const ScanWindow& area,
                           int samples, const HalfSpaceAnswer* halfSpace)
    : area_(area)
    , rest_(withoutScanEdges(area, scene.surface))
    , deformation_(scene, state, scene.model.deformation, halfSpace)
    , field_(scene, state, halfSpace) {
    sample(scene.surface, samples);
}

void ContactShape::sample(const BSplineSurface& surface, int samples) {
    const double middleX = std::clamp(contact().closest.x(), area_.left, area_.right);
    const double middleY = std::clamp(contact().closest.y(), area_.bottom, area_.top);
    const std::vector<double> across = crowded(area_.left, middleX, area_.right, samples);
    const std::vector<double> up = crowded(area_.bottom, middleY, area_.top, samples);
    patch_.columns = samples;
    patch_.rows = samples;
    const std::size_t count = patch_.index(samples, 0);
    patch_.rest.reserve(count);
    patch_.points.reserve(count);
    patch_.normals.reserve(count);
    displacements_.reserve(count);
    for (const double y : up) {
        for (const double x : across) {
            const HeightSample height = surface.at(x, y);
            const Vector3 rest(x, y, height.height);
            const Vector3 point = moved(rest);
            patch_.rest.push_back(rest);
            patch_.points.push_back(point);
            patch_.normals.push_back(height.normal());
            displacements_.push_back((rest - point).dot(contact().normal));
        }
    }
}

double ContactShape::gap(const Vector3& rest, double displacement) const {
    const double tip = tipDisplacement(distanceFromAxis(contact(), rest));
    return field_.gap(rest, displacement, tip);
}

double ContactShape::largestDisplacement() const {
    const auto [low, high] = std::minmax_element(displacements_.begin(), displacements_.end());
    return std::max(-*low, *high);
}

double ContactShape::lowest() const {
    const auto isLower = [](const Vector3& one, const Vector3& other) {
        return one.z() < other.z();
    };
    return std::min_element(patch_.points.begin(), patch_.points.end(), isLower)->z();
}

/// From the contact to where the surface must be at rest, along the shorter side; at most what the
/// rectangle holds [m].
double ContactShape::room() const {
    const Vector3& closest = contact().closest;
    const double x =
        roomAlong(rest_.left, std::clamp(closest.x(), area_.left, area_.right), rest_.right);
    const double y =
        roomAlong(rest_.bottom, std::clamp(closest.y(), area_.bottom, area_.top), rest_.top);
    return std::min({x, y, std::hypot(area_.right - area_.left, area_.top - area_.bottom)});
}

/// 1 where the rectangle holds the contact, down to 0 where the contact fills it: without it the
/// rim, which is high on the tip, would leave spikes in the corners.
double ContactShape::fade() const {
    const double radius = contact().contactRadius;
    const double wanted = (kRoomForContact - 1.0) * radius;
    return wanted > 0.0 ? smoothStep((room() - radius) / wanted) : 1.0;
}

/// 1 inside, smoothly down to 0 at the border but for the scan's edges.
double ContactShape::blend(double x, double y) const {
    const double inX = std::min(x - rest_.left, rest_.right - x);
    const double inY = std::min(y - rest_.bottom, rest_.top - y);
    const double stretch = kBlend * room();
    return fade() * smoothStep(inX / stretch) * smoothStep(inY / stretch);  // round at the corners
}

Vector3 ContactShape::moved(const Vector3& rest) const {
    const double weight = blend(rest.x(), rest.y());
    return weight > 0.0 ? Vector3(rest + weight * deformation_.field()(rest)) : rest;
}

Vector3 ContactShape::contactPoint() const { return moved(contact().closest); }

}  // namespace asperity
