#include "core/probe/ProbeSystem.h"

namespace asperity {

ContactPair ProbeSystem::pairAt(const Vector3& place, double effectiveRadius) const noexcept {
    ContactPair pair = contact.pair();
    pair.tipRadius = effectiveRadius;
    if (field != nullptr) {
        const PlaceMaterial material = field->at(place.x(), place.y());
        pair.reducedModulus = field->reducedModulus(material);
        pair.workOfAdhesion = material.workOfAdhesion;
    }
    return pair;
}

Friction ProbeSystem::frictionAt(const Vector3& place) const noexcept {
    Friction local = friction;
    if (field != nullptr) {
        local.coefficient = field->at(place.x(), place.y()).frictionCoefficient;
    }
    return local;
}

}  // namespace asperity
