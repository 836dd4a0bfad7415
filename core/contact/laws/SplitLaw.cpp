#include "core/contact/laws/SplitLaw.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kTailFraction = 0.1;  // eps of docs/theory.md 3.4

double jointSeparation() noexcept { return kContactSeparation / std::sqrt(kTailFraction); }

/// The pair with the work of adhesion that the cohesive zone has.
ContactPair pairOfZone(const ContactPair& pair, const AdhesionSplit& split) noexcept {
    return {pair.tipRadius, pair.reducedModulus, split.cohesiveWork};
}

}  // namespace

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
