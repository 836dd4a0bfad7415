#include "core/scene/LawRange.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kLargestDmt = 2.5e-4;         // lambda
constexpr double kSmallestJkr = 4.8;           // lambda
constexpr double kWidestAttraction = 0.3;      // of the tip radius
constexpr double kAdhesionOutweighed = 280.0;  // load over pi w R

bool isApart(const ContactState& state) noexcept { return state.branch == ContactBranch::Far; }

/// Radius up to which a tip that is bonded without load is attracted [m]: JKR's contact, the widest
/// of all, and around it where the undeformed gap is within the adhesion's range.
double unloadedReach(const ContactPair& pair) noexcept {
    const double contact = std::cbrt(6.0) * maugisUnits(pair).radius;
    return std::sqrt((contact * contact) + (2.0 * pair.tipRadius * kCohesiveRange));
}

bool reachesTooFar(const ContactPair& pair, double reach) noexcept {
    return reach > kWidestAttraction * pair.tipRadius;
}

/// How far from the axis the law's attraction reaches, or will once it has snapped in [m].
double reachOf(const ContactPair& pair, const ContactState& state) noexcept {
    return isApart(state) ? unloadedReach(pair) : state.cohesiveRadius;
}

bool isWithinRange(const ContactState& state) noexcept {
    return isApart(state) && state.indentation > -kCohesiveRange;
}

double lambdaOf(const ContactPair& pair) noexcept {
    return transitionParameter(maugisUnits(pair), pair.workOfAdhesion / kCohesiveRange);
}

}  // namespace

bool leavesLawsRange(const ContactModel& model, const ContactState& state) noexcept {
    const ContactPair& pair = model.pair();
    const double unit = maugisUnits(pair).force;
    if (pair.workOfAdhesion < kSmallestAdhesion || state.force > kAdhesionOutweighed * unit) {
        return false;
    }
    switch (model.law()) {
    case ContactLaw::Hertz:
    case ContactLaw::Sneddon:
    case ContactLaw::HertzFilm:
        return true;
    case ContactLaw::Dmt:
        return lambdaOf(pair) > kLargestDmt || isWithinRange(state) ||
               reachesTooFar(pair, unloadedReach(pair));
    case ContactLaw::Jkr:
        return lambdaOf(pair) < kSmallestJkr || isWithinRange(state) ||
               reachesTooFar(pair, reachOf(pair, state));
    case ContactLaw::SphereJkr:
        return lambdaOf(pair) < kSmallestJkr || isWithinRange(state);
    case ContactLaw::Maugis:
    case ContactLaw::Split:
        return reachesTooFar(pair, reachOf(pair, state));
    case ContactLaw::SphereMaugis:
        return state.cohesiveRadius >= pair.tipRadius;
    }
    return false;
}

}  // namespace asperity
