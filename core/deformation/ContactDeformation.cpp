#include "core/deformation/ContactDeformation.h"

#include "core/SmoothStep.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

namespace asperity {

namespace {

constexpr double kRounding = 0.15;  // of the contact radius
constexpr double kSharpFrom = 0.4;  // of the tip radius: contact radius from which the rim is sharp
constexpr double kFullFrom = 0.9;   // of the tip radius: from here on it is rounded in full

/// Distance of "far away", in scales.
constexpr double kFar = 1e9;

/// Value at `part` (0 .. 1) of evenly spread samples: the cubic through the four around it.
double interpolated(std::span<const double> samples, double part) {
    const auto intervals = static_cast<double>(samples.size() - 1);
    const double position = std::clamp(part, 0.0, 1.0) * intervals;
    const auto first = static_cast<std::size_t>(std::clamp(position - 1.0, 0.0, intervals - 3.0));
    const double t = position - static_cast<double>(first);  // of the first, in intervals
    const double a = t - 1.0;
    const double b = t - 2.0;
    const double c = t - 3.0;
    return (-samples[first] * a * b * c + 3.0 * samples[first + 1] * t * b * c -
            3.0 * samples[first + 2] * t * a * c + samples[first + 3] * t * a * b) /
           6.0;
}

/// About where the displacement outside the contact has fallen to half of that at its rim.
double scaleOf(const TipContact& contact) {
    constexpr double kOfTheTip = 0.25;  // where there is no contact yet
    return std::max(contact.contactRadius, kOfTheTip * contact.tipRadius);
}

/// Displacement of sample and tip together by the closed form.
std::shared_ptr<const RadialTable> displacementTable(const Scene& scene, const TipState& state) {
    const double rounding = rimRounding(state.contact, scene.belief.tipRadius());
    const auto exact = [&state, model = contactModelAt(scene, state)](double distance) {
        return surfaceDisplacement(model, state.contact, distance);
    };
    return std::make_shared<RadialTable>(
        [&](double distance) { return averagedOverRim(exact, distance, rounding); },
        state.contact.contactRadius, scaleOf(tipContact(scene, state)));
}

/// A paraboloid or a cone goes on beyond the tip's radius where the contact is about as wide.
constexpr double kParaboloidReach = 1.5;  // in contact radii

/// The tip's surface above its lowest point.
double tipRise(const CohesiveContact& profile, const RoundTip& tip, double distance) noexcept {
    return profile.shape == TipShape::Paraboloid ? distance * distance / (2.0 * tip.radius)
                                                 : tip.height(distance);
}

/// Returns how far from the axis there is a tip whose gap is drawn [m].
double tipReach(const CohesiveContact& profile, const TipContact& contact) noexcept {
    return profile.shape == TipShape::Paraboloid || contact.tip().hasCone()
               ? std::max(contact.tipRadius, kParaboloidReach * contact.contactRadius)
               : contact.tipRadius;
}

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

/// Odd powers of even steps from -1 to 1: dense about the middle, where the surface bends most.
double alongOf(int sample, const SectionPlane& plane) {
    const double part = 2.0 * sample / (plane.samples - 1.0) - 1.0;
    return plane.middle + plane.halfWidth * std::pow(part, kCrowding);
}

}  // namespace

double rimRounding(const ContactState& contact, double tipRadius) noexcept {
    const double ratio = contact.contactRadius / tipRadius;
    return kRounding * contact.contactRadius *
           smoothStep((ratio - kSharpFrom) / (kFullFrom - kSharpFrom));
}

// Samples lie at the squares of even steps from the rim, both ways; outwards, those of a variable
// that goes from 0 at the rim to 1 far away, in which what falls off with the distance is smooth.
RadialTable::RadialTable(const std::function<double(double)>& function, double rim, double scale)
    : rim_(rim), scale_(scale) {
    for (int i = 0; i <= kInside; ++i) {
        const double part = static_cast<double>(i) / kInside;
        inside_.at(static_cast<std::size_t>(i)) = function(rim_ * (1.0 - part * part));
    }
    for (int i = 0; i <= kOutside; ++i) {
        const double part = static_cast<double>(i) / kOutside;
        const double away = part * part / std::max(1.0 - part * part, 1.0 / kFar);
        outside_.at(static_cast<std::size_t>(i)) = function(rim_ + scale_ * away);
    }
}

double RadialTable::at(double distance) const {
    if (distance < rim_) {
        return interpolated(inside_, std::sqrt(1.0 - distance / rim_));
    }
    const double away = (distance - rim_) / scale_;
    return interpolated(outside_, std::sqrt(away / (1.0 + away)));
}

TipContact tipContact(const Scene& scene, const TipState& state) {
    const double radius = scene.belief.tipRadius();
    return {.closest = state.closest.point,
            .normal = state.closest.normal,
            .tipCenter = state.tip + Vector3(0.0, 0.0, radius),
            .tipRadius = radius,
            .contactRadius = state.contact.contactRadius,
            .indentation = state.contact.indentation,
            .coneHalfAngle = scene.description.tip.coneHalfAngle};
}

double shareOfSample(const Scene& scene, const TipState& state, DeformationModel model) {
    if (!sharesDisplacement(model)) {
        return 1.0;
    }
    const SceneDescription& description = scene.description;
    Elastic sample = description.sample.material.elastic;
    if (const MaterialField* const field = scene.belief.field.get()) {
        const Vector3& position = state.closest.point;
        sample.youngsModulus = field->at(position.x(), position.y()).youngsModulus;
    }
    return sampleShare(sample, description.tip.elastic);
}

ContactDeformation::ContactDeformation(const Scene& scene, const TipState& state,
                                       DeformationModel model, const HalfSpaceAnswer* halfSpace)
    : contact_(tipContact(scene, state))
    , share_(shareOfSample(scene, state, model))
    , closedForm_(sharesDisplacement(model) ? displacementTable(scene, state) : nullptr)
    , field_(
          fieldFor(scene.surface, model,
                   halfSpace != nullptr && stillHolds(*halfSpace, state) ? halfSpace : nullptr)) {}

DisplacementField ContactDeformation::fieldFor(const BSplineSurface& surface,
                                               DeformationModel model,
                                               const HalfSpaceAnswer* halfSpace) const {
    if (model == DeformationModel::HalfSpace && halfSpace != nullptr) {
        return halfSpaceField(contact_, halfSpace->field, share_);
    }
    return displacementField(surface, contact_, model,
                             [share = share_, table = closedForm_](double distance) {
                                 return share * table->at(distance);
                             });
}

SurfacePatch drawnPatch(const Scene& scene, const ContactDeformation& deformation,
                        const PatchGrid& grid) {
    return deformedPatch(scene.surface, deformation.contact(), grid, deformation.field());
}

SurfacePatch exactPatch(const Scene& scene, const TipState& state, DeformationModel model,
                        const PatchGrid& grid) {
    if (model == DeformationModel::HalfSpace) {
        const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
        if (answer.valid()) {
            return halfSpacePatch(scene, answer, grid);
        }
    }
    return deformedPatch(scene.surface, tipContact(scene, state), grid, model,
                         [&state, share = shareOfSample(scene, state, model),
                          model = contactModelAt(scene, state)](double distance) {
                             return share * surfaceDisplacement(model, state.contact, distance);
                         });
}

SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                            const PatchGrid& grid) {
    const TipContact contact = tipContact(scene, answer.state);
    const double share = shareOfSample(scene, answer.state, DeformationModel::HalfSpace);
    return deformedPatch(scene.surface, contact, grid,
                         halfSpaceField(contact, answer.field, share));
}

Vector3 displacedPoint(const Scene& scene, const TipState& state, DeformationModel model) {
    return state.closest.point -
           shareOfSample(scene, state, model) * state.contact.indentation * state.closest.normal;
}

ContactField::ContactField(const Scene& scene, const TipState& state,
                           const HalfSpaceAnswer* halfSpace)
    : contact_(tipContact(scene, state))
    , profile_(contactProfile(contactModelAt(scene, state), state.contact))
    , reach_(tipReach(profile_, contact_)) {
    if (scene.model.deformation == DeformationModel::HalfSpace && halfSpace != nullptr &&
        stillHolds(*halfSpace, state)) {
        frame_ = tangentFrame(contact_.closest, contact_.normal);
        pixels_ = halfSpace->pressure;
    }
}

double ContactField::gap(const Vector3& rest, double sample, double tip) const noexcept {
    const double distance = distanceFromAxis(contact_, rest);
    if (contact_.contactRadius > 0.0 && distance <= contact_.contactRadius) {
        return 0.0;
    }
    if (!(distance <= reach_)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double lowest =
        (contact_.tipCenter - contact_.closest).dot(contact_.normal) - contact_.tipRadius;
    const double height = (rest - contact_.closest).dot(contact_.normal);
    return std::max(0.0,
                    lowest + tipRise(profile_, contact_.tip(), distance) - height + sample + tip);
}

double ContactField::pressure(const Vector3& rest) const noexcept {
    if (pixels_ == nullptr) {
        return contactPressure(profile_, distanceFromAxis(contact_, rest));
    }
    const Vector3 position = frame_.local(rest);
    const double middle = 0.5 * pixels_->sizeX();
    const bool inside = std::max(std::abs(position.x()), std::abs(position.y())) <= middle;
    return inside ? pixels_->at(middle + position.x(), middle + position.y()) : 0.0;
}

ContactSection contactSection(const Scene& scene, const ContactDeformation& deformation,
                              const SectionPlane& plane) {
    const TipContact& contact = deformation.contact();
    ContactSection section;
    section.axis = contact.tipCenter.head<2>();
    section.direction = {std::cos(plane.azimuth), std::sin(plane.azimuth)};
    const auto inSection = [&](const Vector3& world) -> Vector2 {
        return {(world.head<2>() - section.axis).dot(section.direction), world.z()};
    };
    const auto restAt = [&](const Vector2& position) -> Vector3 {
        return {position.x(), position.y(), scene.surface.at(position.x(), position.y()).height};
    };
    for (int sample = 0; sample < plane.samples; ++sample) {
        const Vector2 position = section.positionAt(alongOf(sample, plane));
        if (scene.surface.contains(position.x(), position.y())) {
            const Vector3 rest = restAt(position);
            section.rest.push_back(inSection(rest));
            section.deformed.push_back(inSection(rest + deformation.field()(rest)));
        }
    }
    section.tip = tipOutline(deformation, plane, section.direction);
    const Vector3 middle = contact.closest + deformation.field()(contact.closest);
    section.contact = inSection(middle);
    if (contact.contactRadius > 0.0) {
        // The contact lies in the tangent plane, which the section cuts along its slope.
        const double rise = contact.normal.head<2>().dot(section.direction);
        const double cosine = contact.normal.z() / std::hypot(rise, contact.normal.z());
        const auto end = [&](double side) {
            const Vector2 position = contact.closest.head<2>() +
                                     side * cosine * contact.contactRadius * section.direction;
            const Vector3 rest = restAt(position);
            return inSection(rest + deformation.field()(rest));
        };
        section.rim = {end(-1.0), end(1.0)};
    }
    return section;
}

}  // namespace asperity
