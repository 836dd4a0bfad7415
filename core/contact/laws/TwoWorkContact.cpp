#include "core/contact/laws/TwoWorkContact.h"

#include "core/Error.h"
#include "core/contact/laws/HertzLaw.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

ContactPair withWork(ContactPair pair, double work) noexcept {
    pair.workOfAdhesion = work;
    return pair;
}

/// The contact of this radius without adhesion.
LawPoint pressedContact(ContactLaw law, const ContactPair& pair, double radius) noexcept {
    return isSphere(law) ? SneddonLaw(pair).at(radius) : HertzLaw(pair).atContactRadius(radius);
}

}  // namespace

TwoWorkContact::TwoWorkContact(ContactLaw law, const ContactPair& pair, double retractWork)
    : growing_(law, pair), shrinking_(law, withWork(pair, retractWork)) {
    if (!isJkr(law)) {
        throw Error("two works of adhesion need a law of JKR: jkr or jkr_sphere");
    }
    if (retractWork < pair.workOfAdhesion) {
        throw Error("the work of adhesion on retract must be at least that on approach");
    }
}

/// The state with the contact radius held, and its energy release rate [J/m^2], < 0 where the
/// edge is pressed on.
ContactState TwoWorkContact::held(double approach, double compliance, const TwoWorkMemory& memory,
                                  double& release) const noexcept {
    const ContactPair& pair = growing_.pair();
    const double radius = memory.contactRadius;
    const LawPoint pressed = pressedContact(growing_.law(), pair, radius);
    const double stiffness = 2.0 * radius * pair.reducedModulus;
    const double lift = (pressed.indentation + (compliance * pressed.force) - approach) /
                        (1.0 + (compliance * stiffness));
    release = radius > 0.0
                  ? lift * std::abs(lift) * pair.reducedModulus / (2.0 * std::numbers::pi * radius)
                  : 0.0;
    return {.force = pressed.force - (stiffness * lift),
            .indentation = pressed.indentation - lift,
            .contactRadius = radius,
            .cohesiveRadius = radius,
            .stiffness = stiffness,
            .branch = ContactBranch::Bonded};
}

ContactState TwoWorkContact::equilibrium(double approach, double compliance,
                                         TwoWorkMemory& memory) const noexcept {
    const auto bonded = [&](const ContactModel& law) {
        return law.equilibrium(approach, compliance, kBondedMemory);
    };
    ContactState state;
    if (memory.branch == ContactBranch::Far) {
        state = growing_.equilibrium(approach, compliance, ContactMemory{});
    } else {
        double release = 0.0;
        state = held(approach, compliance, memory, release);
        if (release < growing_.pair().workOfAdhesion) {
            // An edge that would have to shrink in order to grow is beyond the end of the law.
            const ContactState grown = bonded(growing_);
            state = grown.contactRadius >= memory.contactRadius ? grown : state;
        } else if (release > shrinking_.pair().workOfAdhesion) {
            state = bonded(shrinking_);
            if (state.contactRadius > memory.contactRadius) {
                // The held edge opens beyond the end of the stable states.
                state = shrinking_.equilibrium(approach, compliance, ContactMemory{});
                state.jumped = true;
            }
        }
    }
    memory = {state.branch, state.contactRadius};
    return state;
}

}  // namespace asperity
