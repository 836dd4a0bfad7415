#include "core/deformation/ContactField.h"

#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/DisplacementField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// A paraboloid or a cone goes on beyond the tip's radius where the contact is about as wide.
constexpr double kParaboloidReach = 1.5;  // in contact radii

/// The tip's surface above its lowest point.
double tipRise(const CohesiveContact& profile, const RoundTip& tip, double distance) noexcept {
    return profile.shape == TipShape::Paraboloid ? distance * distance / (2.0 * tip.radius)
                                                 : tip.height(distance);
}

/// How far from the axis there is a tip whose gap is drawn [m].
double tipReach(const CohesiveContact& profile, const TipContact& contact) noexcept {
    return profile.shape == TipShape::Paraboloid || contact.tip().hasCone()
               ? std::max(contact.tipRadius, kParaboloidReach * contact.contactRadius)
               : contact.tipRadius;
}

}  // namespace

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
    const Vector3 place = frame_.local(rest);
    const double middle = 0.5 * pixels_->sizeX();
    const bool inside = std::max(std::abs(place.x()), std::abs(place.y())) <= middle;
    return inside ? pixels_->at(middle + place.x(), middle + place.y()) : 0.0;
}

}  // namespace asperity
