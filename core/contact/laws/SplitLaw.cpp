#include "core/contact/laws/SplitLaw.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kMaxLambda = 1e7;

double creditedStress(const MaugisUnits& units, double stress) noexcept {
    return stress * std::min(1.0, kMaxLambda / transitionParameter(units, stress));
}

constexpr double kTailFraction = 0.1;  // eps of docs/theory.md 3.4

double jointSeparation() noexcept { return kContactSeparation / std::sqrt(kTailFraction); }

/// The pair with the work of adhesion that the cohesive zone has.
ContactPair pairOfZone(const ContactPair& pair, const AdhesionSplit& split) noexcept {
    return {pair.tipRadius, pair.reducedModulus, split.cohesiveWork};
}

}  // namespace

MaugisLaw::MaugisLaw(const ContactPair& pair, double cohesiveStress, MaugisSolver solver) noexcept
    : units_(maugisUnits(pair))
    , cohesiveStress_(creditedStress(units_, cohesiveStress))
    , curve_(transitionParameter(units_, cohesiveStress_), solver.solver == SolverSetting::Exact
                                                               ? MaugisDugdale::LoadFold::Kept
                                                               : MaugisDugdale::LoadFold::OnDemand)
    , solver_(solver) {}

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

/// With the table the coordinate is the state's indentation in Maugis' units.
std::optional<LawPoint> MaugisLaw::stable(double approach, double compliance,
                                          double coordinate) const noexcept {
    const MaugisControl held = control(compliance);
    const double value = approach / units_.indentation;
    if (solver_.solver == SolverSetting::Table && solver_.table != nullptr) {
        const auto state = solver_.table->stable(curve_, held.perForce, value, coordinate);
        return state ? std::optional(inSi(*state)) : std::nullopt;
    }
    if (solver_.solver == SolverSetting::Exact) {
        return stable(approach, compliance);
    }
    const auto point = curve_.stable(held, value, coordinate);
    return point ? std::optional(inSi(*point)) : std::nullopt;
}

LawPoint MaugisLaw::inSi(const MaugisState& state) const noexcept {
    return {.force = state.force * units_.force,
            .indentation = state.indentation * units_.indentation,
            .contactRadius = state.contactRadius * units_.radius,
            .cohesiveRadius = state.cohesiveRadius * units_.radius,
            .stiffness = stiffnessInSi(state.stiffness),
            .coordinate = state.indentation};
}

/// The table's stiffness at a fold is the lowest double, which has no unit.
double MaugisLaw::stiffnessInSi(double stiffness) const noexcept {
    constexpr double kVertical = std::numeric_limits<double>::lowest();
    const double scale = units_.force / units_.indentation;
    return stiffness > kVertical / std::max(1.0, scale) ? stiffness * scale : kVertical;
}

double MaugisLaw::energy(const LawPoint& point) const noexcept {
    const MaugisPoint state = point.contactRadius > 0.0
                                  ? curve_.atContactRadius(point.contactRadius / units_.radius)
                                  : curve_.curve().noncontact(point.cohesiveRadius / units_.radius);
    return curve_.curve().energy(state) * units_.energy();
}

AttractiveTail splitTail(const ContactPair& pair) noexcept {
    return {VanDerWaals(hamakerConstant(pair.workOfAdhesion), pair.tipRadius), pair.reducedModulus,
            jointSeparation()};
}

AdhesionSplit adhesionSplit(const ContactPair& pair, const AttractiveTail& tail) noexcept {
    AdhesionSplit split;
    split.hamaker = tail.attraction().hamaker();
    split.jointSeparation = jointSeparation();
    split.tailSnaps = tail.elasticInstability() > split.jointSeparation;
    const double share = split.tailSnaps ? 1.0 : 1.0 - kTailFraction;
    split.cohesiveWork = share * pair.workOfAdhesion;
    split.cohesiveStress = split.cohesiveWork / (split.jointSeparation - kContactSeparation);
    if (!split.tailSnaps) {
        split.tailForce = tail.attraction().force(split.jointSeparation);
        split.tailLift = tail.lift(split.jointSeparation);
        split.tailEnergy = tail.energy(split.jointSeparation);
    }
    return split;
}

SplitLaw splitLaw(const ContactPair& pair, const AttractiveTail& tail,
                  MaugisSolver solver) noexcept {
    const AdhesionSplit split = adhesionSplit(pair, tail);
    return {split, MaugisLaw(pairOfZone(pair, split), split.cohesiveStress, solver)};
}

SphereSplitLaw sphereSplitLaw(const ContactPair& pair, const AttractiveTail& tail) noexcept {
    const AdhesionSplit split = adhesionSplit(pair, tail);
    return {split, SphereMaugisLaw(pairOfZone(pair, split), split.cohesiveStress)};
}

ConeSplitLaw coneSplitLaw(const ContactPair& pair, const AttractiveTail& tail,
                          double coneHalfAngle) noexcept {
    const AdhesionSplit split = adhesionSplit(pair, tail);
    return {split, ConeMaugisLaw(pairOfZone(pair, split), split.cohesiveStress, coneHalfAngle)};
}

}  // namespace asperity
