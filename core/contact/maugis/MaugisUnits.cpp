#include "core/contact/maugis/MaugisUnits.h"

#include <cmath>
#include <numbers>

namespace asperity {

MaugisUnits maugisUnits(const ContactPair& pair) noexcept {
    const double stiffness = 4.0 / 3.0 * pair.reducedModulus;  // K
    const double force = std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    const double radius = std::cbrt(force * pair.tipRadius / stiffness);
    return {.radius = radius, .force = force, .indentation = radius * (radius / pair.tipRadius)};
}

double transitionParameter(const MaugisUnits& units, double cohesiveStress) noexcept {
    return 2.0 * cohesiveStress * units.radius * units.radius / units.force;
}

}  // namespace asperity
