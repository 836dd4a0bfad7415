#include "core/scene/AttractionValidity.h"

#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/VanDerWaals.h"

#include <numbers>

namespace asperity {

namespace {

constexpr double kMaxShift = 0.05;    // of the separation
constexpr double kMaxMisread = 0.05;  // of the pull-off force
constexpr double kJkrPullOff = 1.5;   // pi w R

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

/// Largest radius of a flat contact that pulls off with its full strength all over [m], not by a
/// crack from its rim. Source: docs/theory.md 2.11, equation (2.8).
double strengthRadius(const ContactPair& pair, double strength) noexcept {
    return 8.0 * pair.reducedModulus * pair.workOfAdhesion /
           (std::numbers::pi * strength * strength);
}

/// Whether JKR would misread w from the pull-off force.
/// @param yields the sample flows under the contact, which stays flat when the load is gone
bool isLimitedByStrength(const ContactModel& model, const ContactState& state,
                         bool yields) noexcept {
    const ContactPair& pair = model.pair();
    if (!isAdhesive(model.law()) || state.branch != ContactBranch::Bonded ||
        pair.workOfAdhesion < kMinAdhesion) {
        return false;
    }
    const double jkr = kJkrPullOff * std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
    const double pull = -(state.force + model.meniscusPull());
    if (traitsOf(model.law()).attraction != Attraction::Inside &&
        pull > (1.0 + kMaxMisread) * jkr) {
        return true;
    }
    const double radius = state.contactRadius;
    const double strength = pair.workOfAdhesion / model.cohesiveRange();
    return yields && radius < strengthRadius(pair, strength) &&
           strength * std::numbers::pi * radius * radius > kMaxMisread * jkr;
}

}  // namespace

bool isPulledByFar(const ContactState& state, double compliance) noexcept {
    return state.branch == ContactBranch::Far &&
           -state.force * compliance > kMaxShift * separationOf(state);
}

ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                 double compliance, bool yields) noexcept {
    ValidityFlags flags;
    flags.set(Validity::RetardedAttraction, isRetarded(model, state, compliance));
    flags.set(Validity::StrengthLimited, isLimitedByStrength(model, state, yields));
    return flags;
}

}  // namespace asperity
