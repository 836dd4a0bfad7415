#include "core/contact/laws/SneddonLaw.h"

#include "core/contact/numerics/RisingSearch.h"

#include <cmath>

namespace asperity {

namespace {

LawPoint pointAt(const SphereContact& contact) noexcept {
    const double a = contact.radius;
    return {.force = sphereForce(contact),
            .indentation = a * contact.depth,
            .contactRadius = a,
            .cohesiveRadius = a,
            .stiffness = 2.0 * a};
}

/// Indentation and deflection of a lever of this compliance, along the depth.
Rise approachAt(const SphereContact& contact, double compliance) noexcept {
    constexpr double kRounding = 4e-16;
    const double a = contact.radius;
    const double value = (a * contact.depth) + (compliance * sphereForce(contact));
    const double indentationRate = a + (contact.depth * contact.rim * contact.rim);
    return {value, indentationRate * (1.0 + (2.0 * a * compliance)), kRounding * value};
}

}  // namespace

LawPoint SneddonLaw::at(double contactRadius) const noexcept {
    return units_.toSi(pointAt(sphereContactOfRadius(contactRadius / units_.length)));
}

LawPoint SneddonLaw::fold(double /*compliance*/) noexcept { return {}; }

std::optional<LawPoint> SneddonLaw::stable(double approach, double compliance) const noexcept {
    if (!(approach > 0.0)) {
        return std::nullopt;
    }
    const double soft = compliance * units_.stiffness;
    const double target = approach / units_.length;
    const double depth = RisingSearch(0.0, 0.0, target)
                             .solve([&](double x) { return approachAt(sphereContact(x), soft); },
                                    std::fmin(std::sqrt(target), target));
    return units_.toSi(pointAt(sphereContact(depth)));
}

double SneddonLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint unit = units_.fromSi(point);
    return units_.energy() *
           sphereElasticEnergy(sphereContactOfRadius(unit.contactRadius), unit.indentation);
}

}  // namespace asperity
