#include "core/surface/deformation/DisplacementField.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

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
