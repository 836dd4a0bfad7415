#include "core/scene/LawRange.h"

#include "core/contact/maugis/MaugisUnits.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// By which a paraboloid's force differs from its sphere's at an indentation, relative.
double paraboloidError(const ContactModel& model, const ContactState& state) noexcept {
    constexpr double kShare = 0.1;  // of the square of a / R
    const double ratio = state.contactRadius / model.pair().tipRadius;
    return traitsOf(model.law()).sphere ? 0.0 : kShare * ratio * ratio;
}

/// Whether contact or attraction reach beyond the sphere that the law knows of the tip.
bool isBeyondTip(const ContactModel& model, const ContactState& state) noexcept {
    const bool isOfSphere = traitsOf(model.law()).sphere;
    const double reach =
        isOfSphere ? std::max(state.contactRadius, state.cohesiveRadius) : state.contactRadius;
    return model.coneHalfAngle() == 0.0 && reach >= model.pair().tipRadius;
}

}  // namespace

LawError lawError(const ContactModel& model, const ContactState& state) noexcept {
    const double force = std::abs(state.force);
    const bool isBeyond = isApart(state) && !isWithinRange(model, state);
    const double near = isBeyond ? model.cohesiveRange() / state.indentation : 1.0;
    const double adhesion = 2.0 * maugisUnits(model.pair()).force * near * near;
    const double error = adhesion + (paraboloidError(model, state) * force);
    return {.force = isBeyondTip(model, state) ? std::numeric_limits<double>::infinity() : error,
            .isSignSure = state.indentation < 0.0 || force > error};
}

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
