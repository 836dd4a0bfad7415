#include "core/surface/deformation/DisplacementField.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kControlsPerRadius = 8.0;

/// From a point near the contact's axis, along that axis, to the side of the tip that faces the
/// sample.
Vector3 ontoTip(const TipContact& contact, const Vector3& point) {
    const double fromAxis = distanceFromAxis(contact, point);
    const double drop = std::sqrt((contact.tipRadius - fromAxis) * (contact.tipRadius + fromAxis));
    const double above = (point - contact.tipCentre).dot(contact.normal);
    return -(above + drop) * contact.normal;
}

}  // namespace

DisplacementField contactRadiusField(const BSplineSurface& surface, const TipContact& contact) {
    SplinePatch net =
        netAroundContact(surface, contact, contact.contactRadius / kControlsPerRadius);
    // A contact wider than the tip has no sphere to lie on beyond the tip's own radius.
    const double reach = std::min(contact.contactRadius, contact.tipRadius);
    for (Vector3& control : net.controls) {
        control = distanceFromAxis(contact, control) <= reach ? ontoTip(contact, control)
                                                              : Vector3(Vector3::Zero());
    }
    return fieldOf(std::move(net));
}

}  // namespace asperity
