#include "core/deformation/ContactSection.h"

#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr int kTipSamples = 96;  // of each half of the outline
constexpr int kCrowding = 3;     // samples crowd about the tip's axis as this power

/// A point of one half of the tip at rest: distance from the axis, height above the apex.
using Profile = std::vector<Vector2>;

/// From the apex up to where the shank begins, then straight on.
Profile tipProfile(const RoundTip& tip, const SectionPlane& plane) {
    const double radius = tip.radius;
    const bool isParaboloid = plane.paraboloidReach > 0.0;
    const double shank = std::numbers::pi / 2.0 - tip.shankHalfAngle();
    const double top = std::acos(std::clamp(1.0 - plane.tipHeight / radius, std::cos(shank), 1.0));
    const double reach = std::min(plane.paraboloidReach, std::sqrt(2.0 * radius * plane.tipHeight));
    Profile profile;
    for (int i = 0; i <= kTipSamples; ++i) {
        const double part = static_cast<double>(i) / kTipSamples;
        const double angle = part * top;
        const double distance = part * reach;
        profile.emplace_back(
            isParaboloid ? Vector2(distance, distance * distance / (2.0 * radius))
                         : Vector2(radius * std::sin(angle), radius * (1.0 - std::cos(angle))));
    }
    const double slope = isParaboloid ? radius / reach : std::tan(tip.shankHalfAngle());
    const double missing = plane.tipHeight - profile.back().y();
    if (missing > 0.0) {
        profile.emplace_back(profile.back().x() + slope * missing, plane.tipHeight);
    }
    return profile;
}

/// Both halves, each point moved into the tip as the contact pushes it.
std::vector<Vector2> tipOutline(const ContactDeformation& deformation, const SectionPlane& plane,
                                const Vector2& direction) {
    const TipContact& contact = deformation.contact();
    const Vector3 apex = contact.tipCenter - contact.tipRadius * Vector3::UnitZ();
    const Profile profile = tipProfile(contact.tip(), plane);
    std::vector<Vector2> outline;
    const auto add = [&](const Vector2& point, double side) {
        const Vector3 arm(side * point.x() * direction.x(), side * point.x() * direction.y(),
                          point.y() - contact.tipRadius);
        const double distance = (arm - arm.dot(contact.normal) * contact.normal).norm();
        const Vector3 moved = arm + deformation.tipDisplacement(distance) * contact.normal;
        outline.emplace_back(moved.head<2>().dot(direction),
                             apex.z() + contact.tipRadius + moved.z());
    };
    std::for_each(profile.rbegin(), profile.rend(),
                  [&](const Vector2& point) { add(point, -1.0); });
    std::for_each(profile.begin() + 1, profile.end(),
                  [&](const Vector2& point) { add(point, 1.0); });
    return outline;
}

/// Odd powers of even steps from -1 to 1: dense about the axis, where the surface bends most.
double alongOf(int sample, const SectionPlane& plane) {
    const double part = 2.0 * sample / (plane.samples - 1.0) - 1.0;
    return plane.halfWidth * std::pow(part, kCrowding);
}

}  // namespace

ContactSection contactSection(const Scene& scene, const ContactDeformation& deformation,
                              const SectionPlane& plane) {
    const TipContact& contact = deformation.contact();
    ContactSection section;
    section.axis = contact.tipCenter.head<2>();
    section.direction = {std::cos(plane.azimuth), std::sin(plane.azimuth)};
    const auto inSection = [&](const Vector3& world) -> Vector2 {
        return {(world.head<2>() - section.axis).dot(section.direction), world.z()};
    };
    const auto restAt = [&](const Vector2& place) -> Vector3 {
        return {place.x(), place.y(), scene.surface.at(place.x(), place.y()).height};
    };
    for (int sample = 0; sample < plane.samples; ++sample) {
        const Vector2 place = section.placeAt(alongOf(sample, plane));
        if (scene.surface.contains(place.x(), place.y())) {
            const Vector3 rest = restAt(place);
            section.rest.push_back(inSection(rest));
            section.deformed.push_back(inSection(rest + deformation.field()(rest)));
        }
    }
    section.tip = tipOutline(deformation, plane, section.direction);
    const Vector3 middle = contact.closest + deformation.field()(contact.closest);
    section.contact = inSection(middle);
    if (contact.contactRadius > 0.0) {
        const auto end = [&](double side) {
            const Vector2 place =
                contact.closest.head<2>() + side * contact.contactRadius * section.direction;
            const Vector3 rest = restAt(place);
            return inSection(rest + deformation.field()(rest));
        };
        section.rim = {end(-1.0), end(1.0)};
    }
    return section;
}

}  // namespace asperity
