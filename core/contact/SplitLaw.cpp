#include "core/contact/SplitLaw.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kTailFraction = 0.1;  // eps of docs/physics.md 3.4

double jointSeparation() noexcept { return kContactSeparation / std::sqrt(kTailFraction); }

AdhesionSplit splitOf(const ContactPair& pair, const AttractiveTail& tail) noexcept {
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
    }
    return split;
}

MaugisLaw zoneOf(const ContactPair& pair, const AdhesionSplit& split,
                 MaugisSolver solver) noexcept {
    const ContactPair share{pair.tipRadius, pair.reducedModulus, split.cohesiveWork};
    return {share, split.cohesiveStress, std::move(solver)};
}

}  // namespace

AttractiveTail splitTail(const ContactPair& pair) noexcept {
    return {VanDerWaals(hamakerConstant(pair.workOfAdhesion), pair.tipRadius), pair.reducedModulus,
            jointSeparation()};
}

SplitLaw::SplitLaw(const ContactPair& pair, const AttractiveTail& tail,
                   MaugisSolver solver) noexcept
    : tail_(tail), split_(splitOf(pair, tail)), zone_(zoneOf(pair, split_, std::move(solver))) {
    split_.cohesiveStress = zone_.cohesiveStress();
}

LawPoint SplitLaw::withTail(LawPoint point) const noexcept {
    point.force += split_.tailForce;
    point.indentation -= split_.tailLift;
    return point;
}

LawPoint SplitLaw::fold(double compliance) const noexcept {
    return withTail(zone_.fold(compliance));
}

std::optional<LawPoint> SplitLaw::stable(double approach, double compliance) const noexcept {
    const auto point = zone_.stable(approachOfZone(approach, compliance), compliance);
    return point ? std::optional(withTail(*point)) : std::nullopt;
}

std::optional<LawPoint> SplitLaw::stable(double approach, double compliance,
                                         double coordinate) const noexcept {
    const auto point = zone_.stable(approachOfZone(approach, compliance), compliance, coordinate);
    return point ? std::optional(withTail(*point)) : std::nullopt;
}

double SplitLaw::approachOfZone(double approach, double compliance) const noexcept {
    return approach + split_.tailLift - (compliance * split_.tailForce);
}

double SplitLaw::energy(const LawPoint& point) const noexcept {
    const double moved = point.indentation + split_.tailLift - zone_.onset();
    const double joint = split_.tailSnaps ? 0.0 : tail_.energy(split_.jointSeparation);
    return joint + (split_.tailForce * moved) + zone_.energy(point);
}

}  // namespace asperity
