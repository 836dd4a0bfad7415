#include "ui/view/ContactShape.h"

#include "core/SmoothStep.h"
#include "core/contact/SurfaceDisplacement.h"
#include "core/scene/ContactPatch.h"
#include "core/scene/RimRounding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Part of the rectangle's half width over which the displacement goes over into rest.
constexpr double kBlend = 0.35;

/// In contact radii: a narrower rectangle begins to cut the contact's rim, and shows less of it.
constexpr double kRoomForContact = 1.6;

/// Samples at the border lie cosh(k) times as far apart as at the contact.
constexpr double kCrowding = 4.0;

/// Places from `low` to `high`, crowded about `middle`, which is one of them for odd counts.
std::vector<double> crowded(double low, double middle, double high, int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i) {
        const double part = 2.0 * i / (count - 1) - 1.0;
        const double away = std::sinh(kCrowding * std::abs(part)) / std::sinh(kCrowding);
        places.push_back(std::lerp(middle, part < 0.0 ? low : high, away));
    }
    return places;
}

double sampleShareOf(const Scene& scene) {
    const SceneDescription& description = scene.description;
    return sharesDisplacement(description.deformation)
               ? sampleShare(description.sample.material.elastic, description.tip.elastic)
               : 1.0;
}

RadialTable displacementTable(const Scene& scene, const TipState& state, const ScanWindow& area) {
    const double reach = std::hypot(area.right - area.left, area.top - area.bottom);
    const double rounding = rimRounding(state.contact, scene.belief.tipRadius());
    const auto exact = [&, model = contactModelAt(scene, state)](double distance) {
        return surfaceDisplacement(model, state.contact, distance);
    };
    return {[&](double distance) { return averagedOverRim(exact, distance, rounding); },
            state.contact.contactRadius, reach};
}

}  // namespace

bool isDrawable(const TipState& state) {
    const ContactState& contact = state.contact;
    return state.tip.allFinite() && state.foot.point.allFinite() && state.foot.normal.allFinite() &&
           std::isfinite(contact.contactRadius) && std::isfinite(contact.indentation) &&
           std::isfinite(contact.force);
}

ContactShape::ContactShape(const Scene& scene, const TipState& state, const ScanWindow& area,
                           int samples, const HalfSpaceAnswer* halfSpace)
    : area_(area)
    , contact_(tipContact(scene, state))
    , share_(sampleShareOf(scene))
    , table_(displacementTable(scene, state, area))
    , field_(fieldFor(scene, halfSpace != nullptr && stillHolds(*halfSpace, state) ? halfSpace
                                                                                   : nullptr)) {
    sample(scene.surface, samples);
}

DisplacementField ContactShape::fieldFor(const Scene& scene,
                                         const HalfSpaceAnswer* halfSpace) const {
    const DeformationTier tier = scene.description.deformation;
    if (tier == DeformationTier::HalfSpace && halfSpace != nullptr) {
        return halfSpaceField(contact_, halfSpace->field, share_);
    }
    if (sharesDisplacement(tier)) {
        return closedFormField(contact_,
                               [this](double distance) { return share_ * table_.at(distance); });
    }
    if (contact_.contactRadius == 0.0) {  // the other tiers move what the tip touches
        return [](const Vector3&) -> Vector3 { return Vector3::Zero(); };
    }
    return tier == DeformationTier::FourPoint ? fourPointField(scene.surface, contact_)
                                              : contactRadiusField(scene.surface, contact_);
}

void ContactShape::sample(const BSplineSurface& surface, int samples) {
    const double middleX = std::clamp(contact_.foot.x(), area_.left, area_.right);
    const double middleY = std::clamp(contact_.foot.y(), area_.bottom, area_.top);
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
            displacements_.push_back((rest - point).dot(contact_.normal));
        }
    }
}

double ContactShape::largestDisplacement() const {
    const auto [low, high] = std::minmax_element(displacements_.begin(), displacements_.end());
    return std::max(-*low, *high);
}

/// Of the shorter side [m].
double ContactShape::halfWidth() const {
    return 0.5 * std::min(area_.right - area_.left, area_.top - area_.bottom);
}

/// 1 where the rectangle holds the contact, down to 0 where the contact fills it: without it the
/// rim, which stands high on the tip, would leave spikes in the corners.
double ContactShape::fade() const {
    const double radius = contact_.contactRadius;
    const double room = (kRoomForContact - 1.0) * radius;
    return room > 0.0 ? smoothStep((halfWidth() - radius) / room) : 1.0;
}

/// 1 inside, smoothly down to 0 at the border.
double ContactShape::blend(double x, double y) const {
    const double inX = std::min(x - area_.left, area_.right - x);
    const double inY = std::min(y - area_.bottom, area_.top - y);
    return fade() * smoothStep(std::min(inX, inY) / (kBlend * halfWidth()));
}

Vector3 ContactShape::moved(const Vector3& rest) const {
    const double weight = blend(rest.x(), rest.y());
    return weight > 0.0 ? Vector3(rest + weight * field_(rest)) : rest;
}

double ContactShape::tipDisplacement(double distance) const {
    return (1.0 - share_) * table_.at(distance);
}

Vector3 ContactShape::contactPoint() const { return moved(contact_.foot); }

}  // namespace asperity
