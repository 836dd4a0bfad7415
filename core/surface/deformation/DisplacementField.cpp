#include "core/surface/deformation/DisplacementField.h"

#include <algorithm>
#include <utility>

namespace asperity {

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

}  // namespace asperity
