#include "core/surface/deformation/DisplacementField.h"

#include <utility>

namespace asperity {

DisplacementField closedFormField(const TipContact& contact, RadialDisplacement displacement) {
    return [contact, u = std::move(displacement)](const Vector3& rest) -> Vector3 {
        return -u(distanceFromAxis(contact, rest)) * contact.normal;
    };
}

}  // namespace asperity
