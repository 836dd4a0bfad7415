#include "core/contact/ContactModel.h"

#include "core/Error.h"
#include "core/contact/ClassicContact.h"
#include "core/contact/Within.h"

namespace asperity {

namespace {

// Far beyond any instrument, and near enough that no power of them overflows.
constexpr double kSmallestRadius = 1e-12;    // [m]
constexpr double kLargestRadius = 1.0;       // [m]
constexpr double kSmallestModulus = 1.0;     // [Pa]
constexpr double kLargestModulus = 1e15;     // [Pa]
constexpr double kSmallestAdhesion = 1e-12;  // [J/m^2]
constexpr double kLargestAdhesion = 1e3;     // [J/m^2]
constexpr double kLargestApproach = 1e3;     // [m]
constexpr double kLargestCompliance = 1e6;   // [m/N]

void check(const ContactPair& pair) {
    if (!isWithin(pair.tipRadius, kSmallestRadius, kLargestRadius)) {
        throw Error("contact: the tip radius must lie between 1e-12 and 1 m");
    }
    if (!isWithin(pair.reducedModulus, kSmallestModulus, kLargestModulus)) {
        throw Error("contact: the reduced modulus must lie between 1 and 1e15 Pa");
    }
    if (!isWithin(pair.workOfAdhesion, 0.0, kLargestAdhesion)) {
        throw Error("contact: the work of adhesion must lie between 0 and 1000 J/m^2");
    }
}

}  // namespace

ContactModel::ContactModel(ContactLaw law, const ContactPair& pair) : law_(law), pair_(pair) {
    check(pair);
    if (law == ContactLaw::Split && pair.workOfAdhesion >= kSmallestAdhesion) {
        adhesion_.emplace(pair);
    }
}

ContactState ContactModel::equilibrium(double approach, double compliance,
                                       ContactBranch branch) const noexcept {
    if (!isWithin(approach, -kLargestApproach, kLargestApproach) ||
        !isWithin(compliance, 0.0, kLargestCompliance)) {
        ContactState state;
        state.branch = branch;
        state.solved = false;
        return state;
    }
    return adhesion_ ? adhesion_->equilibrium(approach, compliance, branch)
                     : hertz(approach, compliance);
}

ContactState ContactModel::hertz(double approach, double compliance) const noexcept {
    ContactState state;
    state.indentation = hertzIndentation(pair_, approach, compliance);
    state.force = hertzForce(pair_, state.indentation);
    state.contactRadius = hertzContactRadius(pair_, state.indentation);
    state.cohesiveRadius = state.contactRadius;
    state.branch = state.indentation > 0.0 ? ContactBranch::Bonded : ContactBranch::Far;
    return state;
}

double ContactModel::jumpInApproach(double compliance) const noexcept {
    return adhesion_ ? adhesion_->jumpInApproach(compliance) : 0.0;
}

double ContactModel::pullOffApproach(double compliance) const noexcept {
    return adhesion_ ? adhesion_->pullOffApproach(compliance) : 0.0;
}

}  // namespace asperity
