#include "core/contact/laws/SneddonLaw.h"

#include "core/contact/numerics/RisingSearch.h"

#include <cmath>

namespace asperity {

LawPoint SneddonLaw::pointAt(const PunchContact& contact) const noexcept {
    const double a = contact.radius;
    return units_.toSi({.force = punch_.force(contact),
                        .indentation = a * contact.depth,
                        .contactRadius = a,
                        .cohesiveRadius = a,
                        .stiffness = 2.0 * a});
}

/// Indentation and deflection of a lever of this compliance, along the tip.
Rise SneddonLaw::approachAt(const PunchContact& contact, double compliance) const noexcept {
    constexpr double kRounding = 4e-16;
    const double a = contact.radius;
    const double value = (a * contact.depth) + (compliance * punch_.force(contact));
    const double indentationRate =
        (a * contact.depthRate) + (contact.depth * contact.rim * contact.rim);
    return {value, indentationRate * (1.0 + (2.0 * a * compliance)), kRounding * value};
}

LawPoint SneddonLaw::at(double contactRadius) const noexcept {
    return pointAt(punch_.contactOfRadius(contactRadius / units_.length));
}

LawPoint SneddonLaw::fold(double /*compliance*/) noexcept { return {}; }

std::optional<LawPoint> SneddonLaw::stable(double approach, double compliance) const noexcept {
    if (!(approach > 0.0)) {
        return std::nullopt;
    }
    const double soft = compliance * units_.stiffness;
    const double target = approach / units_.length;
    const double coordinate =
        RisingSearch(0.0, 0.0, target)
            .solve([&](double x) { return approachAt(punch_.contact(x), soft); },
                   std::fmin(std::sqrt(target), target));
    return pointAt(punch_.contact(coordinate));
}

double SneddonLaw::energy(const LawPoint& point) const noexcept {
    const LawPoint unit = units_.fromSi(point);
    return units_.energy() *
           punch_.elasticEnergy(punch_.contactOfRadius(unit.contactRadius), unit.indentation);
}

}  // namespace asperity
