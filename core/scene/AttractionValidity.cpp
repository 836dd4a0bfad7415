#include "core/scene/AttractionValidity.h"

#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/Retardation.h"
#include "core/scene/LawRange.h"

#include <numbers>

namespace asperity {

namespace {

constexpr double kMaxShift = 0.05;                // of the separation
constexpr double kMinLambdaWorkLimited = 0.4246;  // lambda: pull-off at 1.75 pi w R

double separationOf(const ContactState& state) noexcept {
    return kContactSeparation - state.indentation;
}

/// Whether the tip would be elsewhere if light took its time, as it does.
bool isRetarded(const ContactModel& model, const ContactState& state, double compliance) noexcept {
    if (model.tail() == nullptr || !isPulledByFar(state, compliance)) {
        return false;
    }
    const double separation = separationOf(state);
    const double lost = -model.tail()->attraction().force(separation) * retardedShare(separation);
    return lost * compliance > kMaxShift * separation;
}

bool isLimitedByStrength(const ContactModel& model, const ContactState& state) noexcept {
    const ContactPair& pair = model.pair();
    const double unit = std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    return isAdhesive(model.law()) && state.branch == ContactBranch::Bonded &&
           pair.workOfAdhesion >= kMinAdhesion && state.force < -unit &&
           pairLambda(model) < kMinLambdaWorkLimited;
}

}  // namespace

bool isPulledByFar(const ContactState& state, double compliance) noexcept {
    return state.branch == ContactBranch::Far &&
           -state.force * compliance > kMaxShift * separationOf(state);
}

ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                 double compliance) noexcept {
    ValidityFlags flags;
    flags.set(Validity::RetardedAttraction, isRetarded(model, state, compliance));
    flags.set(Validity::StrengthLimited, isLimitedByStrength(model, state));
    return flags;
}

}  // namespace asperity
