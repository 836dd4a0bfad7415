#include "core/contact/MaugisLaw.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kLargestLambda = 1e7;

double creditedStress(const MaugisUnits& units, double stress) noexcept {
    return stress * std::min(1.0, kLargestLambda / transitionParameter(units, stress));
}

}  // namespace

MaugisLaw::MaugisLaw(const ContactPair& pair, double cohesiveStress) noexcept
    : units_(maugisUnits(pair))
    , cohesiveStress_(creditedStress(units_, cohesiveStress))
    , curve_(transitionParameter(units_, cohesiveStress_)) {}

double MaugisLaw::range() const noexcept { return curve_.curve().range() * units_.indentation; }

MaugisControl MaugisLaw::control(double compliance) const noexcept {
    return MaugisControl::spring(compliance * units_.force / units_.indentation);
}

LawPoint MaugisLaw::inSi(const MaugisPoint& point) const noexcept {
    return {.force = point.force * units_.force,
            .indentation = point.indentation * units_.indentation,
            .contactRadius = point.contactRadius * units_.radius,
            .cohesiveRadius = point.cohesiveRadius * units_.radius,
            .stiffness = curveStiffness(point.forceRate * units_.force,
                                        point.indentationRate * units_.indentation),
            .coordinate = point.coordinate};
}

LawPoint MaugisLaw::fold(double compliance) const noexcept {
    return inSi(curve_.fold(control(compliance)));
}

std::optional<LawPoint> MaugisLaw::stable(double approach, double compliance) const noexcept {
    const auto point = curve_.stable(control(compliance), approach / units_.indentation);
    return point ? std::optional(inSi(*point)) : std::nullopt;
}

/// The curve's energy needs the whole point; a state with contact is one coordinate.
double MaugisLaw::energy(const LawPoint& point) const noexcept {
    const MaugisCurve& curve = curve_.curve();
    const MaugisPoint state = point.contactRadius > 0.0
                                  ? curve.contact(point.coordinate)
                                  : curve.noncontact(point.cohesiveRadius / units_.radius);
    return curve.energy(state) * units_.energy();
}

}  // namespace asperity
