#include "core/contact/SplitLaw.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kTailFraction = 0.1;   // eps of docs/physics.md 3.4
constexpr double kLargestLambda = 1e7;  // beyond it the curve is JKR's to 1e-13

double jointSeparation() noexcept { return kContactSeparation / std::sqrt(kTailFraction); }

AttractiveTail tailOf(const ContactPair& pair) noexcept {
    return {VanDerWaals(hamakerConstant(pair.workOfAdhesion), pair.tipRadius), pair.reducedModulus,
            jointSeparation()};
}

ContactPair withWork(const ContactPair& pair, double work) noexcept {
    return {pair.tipRadius, pair.reducedModulus, work};
}

/// The cohesive stress is lowered where it would lead beyond the largest lambda.
AdhesionSplit splitOf(const ContactPair& pair, const AttractiveTail& tail) noexcept {
    AdhesionSplit split;
    split.hamaker = tail.attraction().hamaker();
    split.jointSeparation = jointSeparation();
    split.tailSnaps = tail.elasticInstability() > split.jointSeparation;
    const double share = split.tailSnaps ? 1.0 : 1.0 - kTailFraction;
    split.cohesiveWork = share * pair.workOfAdhesion;
    if (!split.tailSnaps) {
        split.tailForce = tail.attraction().force(split.jointSeparation);
        split.tailLift = tail.lift(split.jointSeparation);
    }
    const MaugisUnits units = maugisUnits(withWork(pair, split.cohesiveWork));
    const double stress = split.cohesiveWork / (split.jointSeparation - kContactSeparation);
    const double lambda = transitionParameter(units, stress);
    split.cohesiveStress = stress * std::min(1.0, kLargestLambda / lambda);
    return split;
}

double springEnergy(double force, double compliance) noexcept {
    return 0.5 * compliance * force * force;
}

}  // namespace

SplitLaw::SplitLaw(const ContactPair& pair) noexcept
    : tail_(tailOf(pair))
    , split_(splitOf(pair, tail_))
    , units_(maugisUnits(withWork(pair, split_.cohesiveWork)))
    , bonded_(transitionParameter(units_, split_.cohesiveStress))
    , jointEnergy_(split_.tailSnaps ? 0.0 : tail_.energy(split_.jointSeparation)) {}

MaugisControl SplitLaw::control(double compliance) const noexcept {
    return MaugisControl::spring(compliance * units_.force / units_.indentation);
}

double SplitLaw::heldValue(double approach, double compliance) const noexcept {
    return (approach + split_.tailLift - (compliance * split_.tailForce)) / units_.indentation;
}

ContactState SplitLaw::equilibrium(double approach, double compliance,
                                   ContactBranch branch) const noexcept {
    if (branch == ContactBranch::Far) {
        const double end = tail_.endSeparation(compliance);
        if (approach > tail_.approach(end, compliance)) {
            return snapIn(approach, compliance, end);
        }
        return farState(tail_.separationAt(approach, compliance, end));
    }
    const auto point = bonded_.stable(control(compliance), heldValue(approach, compliance));
    return point ? bondedState(*point) : pullOff(approach, compliance);
}

ContactState SplitLaw::snapIn(double approach, double compliance, double end) const noexcept {
    ContactState state = bondedState(bondedAt(approach, compliance));
    const MaugisPoint landing = bondedAt(tail_.approach(end, compliance), compliance);
    state.jumped = true;
    state.energyLost =
        std::max(0.0, farEnergy(end, compliance) - bondedEnergy(landing, compliance));
    return state;
}

ContactState SplitLaw::pullOff(double approach, double compliance) const noexcept {
    const double end = tail_.endSeparation(compliance);
    ContactState state = farState(tail_.separationAt(approach, compliance, end));
    const MaugisPoint fold = bonded_.fold(control(compliance));
    const double landing = tail_.separationAt(pullOffApproach(compliance), compliance, end);
    state.jumped = true;
    state.energyLost =
        std::max(0.0, bondedEnergy(fold, compliance) - farEnergy(landing, compliance));
    return state;
}

double SplitLaw::jumpInApproach(double compliance) const noexcept {
    return tail_.approach(tail_.endSeparation(compliance), compliance);
}

double SplitLaw::pullOffApproach(double compliance) const noexcept {
    const ContactState fold = bondedState(bonded_.fold(control(compliance)));
    return fold.indentation + (compliance * fold.force);
}

/// The bonded state at an approach where one must exist; rounding may put it on the fold.
MaugisPoint SplitLaw::bondedAt(double approach, double compliance) const noexcept {
    const MaugisControl held = control(compliance);
    const auto point = bonded_.stable(held, heldValue(approach, compliance));
    return point ? *point : bonded_.fold(held);
}

ContactState SplitLaw::farState(double separation) const noexcept {
    ContactState state;
    state.force = tail_.attraction().force(separation);
    state.indentation = tail_.indentation(separation);
    return state;
}

ContactState SplitLaw::bondedState(const MaugisPoint& point) const noexcept {
    ContactState state;
    state.force = (point.force * units_.force) + split_.tailForce;
    state.indentation = (point.indentation * units_.indentation) - split_.tailLift;
    state.contactRadius = point.contactRadius * units_.radius;
    state.cohesiveRadius = point.cohesiveRadius * units_.radius;
    state.branch = ContactBranch::Bonded;
    return state;
}

double SplitLaw::farEnergy(double separation, double compliance) const noexcept {
    return tail_.energy(separation) +
           springEnergy(tail_.attraction().force(separation), compliance);
}

double SplitLaw::bondedEnergy(const MaugisPoint& point, double compliance) const noexcept {
    const double moved = (point.indentation + bonded_.curve().range()) * units_.indentation;
    const double force = (point.force * units_.force) + split_.tailForce;
    return jointEnergy_ + (split_.tailForce * moved) +
           (bonded_.curve().energy(point) * units_.energy()) + springEnergy(force, compliance);
}

}  // namespace asperity
