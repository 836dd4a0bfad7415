#include "core/scene/LawRange.h"

#include "core/contact/maugis/MaugisUnits.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kMaxLambdaDmt = 2.5e-4;       // lambda
constexpr double kMinLambdaJkr = 4.8;          // lambda
constexpr double kMaxReach = 0.3;              // of the tip radius
constexpr double kAdhesionOutweighed = 280.0;  // load over pi w R

bool isApart(const ContactState& state) noexcept { return state.branch == ContactBranch::Far; }

/// Radius up to which a tip that is bonded without load is attracted [m]: JKR's contact, the widest
/// of all, and around it where the undeformed gap is within the adhesion's range.
double unloadedReach(const ContactModel& model) noexcept {
    const ContactPair& pair = model.pair();
    const double contact = std::cbrt(6.0) * maugisUnits(pair).radius;
    return std::sqrt((contact * contact) + (2.0 * pair.tipRadius * model.cohesiveRange()));
}

bool reachesTooFar(const ContactModel& model, double reach) noexcept {
    return reach > kMaxReach * model.pair().tipRadius;
}

/// How far from the axis the law's attraction reaches, or will once it has snapped in [m].
double reachOf(const ContactModel& model, const ContactState& state) noexcept {
    return isApart(state) ? unloadedReach(model) : state.cohesiveRadius;
}

bool isWithinRange(const ContactModel& model, const ContactState& state) noexcept {
    return isApart(state) && state.indentation > -model.cohesiveRange();
}

}  // namespace

double pairLambda(const ContactModel& model) noexcept {
    const ContactPair& pair = model.pair();
    return transitionParameter(maugisUnits(pair), pair.workOfAdhesion / model.cohesiveRange());
}

bool leavesLawsRange(const ContactModel& model, const ContactState& state) noexcept {
    const ContactPair& pair = model.pair();
    const double unit = maugisUnits(pair).force;
    if (pair.workOfAdhesion < kMinAdhesion || state.force > kAdhesionOutweighed * unit) {
        return false;
    }
    const LawTraits& law = traitsOf(model.law());
    switch (law.attraction) {
    case Attraction::None:
        return true;
    case Attraction::Outside:
        return pairLambda(model) > kMaxLambdaDmt || isWithinRange(model, state) ||
               reachesTooFar(model, unloadedReach(model));
    case Attraction::Inside:
        return pairLambda(model) < kMinLambdaJkr || isWithinRange(model, state) ||
               (!law.sphere && reachesTooFar(model, reachOf(model, state)));
    case Attraction::Zone:
        return law.sphere ? model.coneHalfAngle() == 0.0 && state.cohesiveRadius >= pair.tipRadius
                          : reachesTooFar(model, reachOf(model, state));
    }
    return false;
}

}  // namespace asperity
