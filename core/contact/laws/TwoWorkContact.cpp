#include "core/contact/laws/TwoWorkContact.h"

#include "core/contact/laws/HertzLaw.h"

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// The contact of this radius without adhesion.
LawPoint pressedContact(const ContactModel& model, double radius) noexcept {
    return isSphere(model.law()) ? SneddonLaw(model.pair(), model.coneHalfAngle()).at(radius)
                                 : HertzLaw(model.pair()).atContactRadius(radius);
}

}  // namespace

/// The state with the contact radius held, and its energy release rate [J/m^2], < 0 where the
/// edge is pressed on.
ContactState TwoWorkContact::held(double approach, double compliance, double radius,
                                  double& release) const noexcept {
    const ContactPair& pair = growing_.pair();
    const LawPoint pressed = pressedContact(growing_, radius);
    const double stiffness = 2.0 * radius * pair.reducedModulus;
    const double lift = (pressed.indentation + (compliance * pressed.force) - approach) /
                        (1.0 + (compliance * stiffness));
    release = lift * std::abs(lift) * pair.reducedModulus / (2.0 * std::numbers::pi * radius);
    return {.force = pressed.force - (stiffness * lift),
            .indentation = pressed.indentation - lift,
            .contactRadius = radius,
            .cohesiveRadius = radius,
            .stiffness = stiffness,
            .branch = ContactBranch::Bonded};
}

ContactState TwoWorkContact::equilibrium(double approach, double compliance,
                                         const ContactMemory& memory) const noexcept {
    if (memory.branch == ContactBranch::Far) {
        return growing_.equilibrium(approach, compliance, memory);
    }
    const double radius = memory.contactRadius;
    if (!(radius > 0.0)) {
        return shrinking_.equilibrium(approach, compliance, kBondedMemory);
    }
    double release = 0.0;
    ContactState state = held(approach, compliance, radius, release);
    if (release < growing_.pair().workOfAdhesion) {
        // An edge that would have to shrink in order to grow is beyond the end of the law.
        const ContactState grown = growing_.equilibrium(approach, compliance, kBondedMemory);
        return grown.contactRadius >= radius ? grown : state;
    }
    if (release > shrinking_.pair().workOfAdhesion) {
        state = shrinking_.equilibrium(approach, compliance, kBondedMemory);
        if (state.contactRadius > radius) {
            // The held edge opens beyond the end of the stable states.
            state = shrinking_.equilibrium(approach, compliance, ContactMemory{});
            state.jumped = true;
        }
    }
    return state;
}

}  // namespace asperity
