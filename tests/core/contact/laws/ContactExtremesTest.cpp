#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/AnyContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using test::anyApproach;
using test::AnyContact;
using test::anyContact;
using test::anyDryContact;

constexpr double kRounding = 1e-13;

bool isFiniteWithCoordinate(const ContactState& state) {
    return test::isFinite(state) && std::isfinite(state.coordinate);
}

/// Rounding of a base position that balances a state [m].
double approachRounding(const AnyContact& contact, const ContactModel& model,
                        const ContactState& state) {
    return kRounding * (indentationSize(contact, model, state) +
                        (contact.compliance * forceSize(contact, model, state)));
}

TEST(ContactExtremes, EveryStateIsFiniteAndWellFormed) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        RC_TAG(nameOf(contact.law));
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double approach = anyApproach(model, contact.compliance);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = model.equilibrium(approach, contact.compliance, {branch});
            RC_ASSERT(state.solved());
            RC_ASSERT(isFiniteWithCoordinate(state));
            RC_ASSERT(state.energyLost >= 0.0);
            RC_ASSERT(state.contactRadius >= 0.0);
            RC_ASSERT(state.cohesiveRadius >= state.contactRadius);
            RC_ASSERT(state.branch == ContactBranch::Bonded || state.cohesiveRadius == 0.0);
            RC_ASSERT(state.branch == branch || !state.jumped || state.energyLost >= 0.0);
        }
        RC_ASSERT(isFiniteWithCoordinate(model.lastBonded(contact.compliance)));
    });
}

TEST(ContactExtremes, EveryStateBalancesTheLever) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double approach = anyApproach(model, contact.compliance);
        for (const ContactBranch branch : {ContactBranch::Far, ContactBranch::Bonded}) {
            const ContactState state = model.equilibrium(approach, contact.compliance, {branch});
            const double off = state.indentation + (contact.compliance * state.force) - approach;
            RC_ASSERT(std::abs(off) <=
                      (kRounding * std::abs(approach)) + approachRounding(contact, model, state));
        }
    });
}

/// The branch is kept while it is stable, left with one jump where it is not.
TEST(ContactExtremes, BranchesAreKeptWhileTheyAreStable) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double compliance = contact.compliance;
        const double pullOff = model.pullOffApproach(compliance);
        const double jumpIn = model.jumpInApproach(compliance);
        const ContactState last = model.lastBonded(compliance);
        const double margin =
            1e-11 * (std::abs(pullOff) + std::abs(jumpIn)) + approachRounding(contact, model, last);
        const double radius = model.pair().tipRadius;
        RC_ASSERT(pullOff <= jumpIn + margin);
        const double beyond = radius * *test::logUniform(1e-9, 1.0);
        const auto branchAt = [&](double approach, ContactBranch branch) {
            return model.equilibrium(approach, compliance, {branch}).branch;
        };
        RC_ASSERT(branchAt(pullOff + margin + beyond, ContactBranch::Bonded) ==
                  ContactBranch::Bonded);
        RC_ASSERT(branchAt(pullOff - margin - beyond, ContactBranch::Bonded) == ContactBranch::Far);
        RC_ASSERT(branchAt(jumpIn - margin - beyond, ContactBranch::Far) == ContactBranch::Far);
        RC_ASSERT(branchAt(jumpIn + margin + beyond, ContactBranch::Far) == ContactBranch::Bonded);
    });
}

TEST(ContactExtremes, TheLastBondedStateIsWhereTheTipPullsOff) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const ContactState last = model.lastBonded(contact.compliance);
        const double held = last.indentation + (contact.compliance * last.force);
        RC_ASSERT(last.branch == ContactBranch::Bonded);
        RC_ASSERT(std::abs(held - model.pullOffApproach(contact.compliance)) <=
                  approachRounding(contact, model, last));
    });
}

/// An approach above the fold by far more than rounding, not deeper than 10 R.
double wellAboveFold(const AnyContact& contact, const ContactModel& model) {
    const double pullOff = model.pullOffApproach(contact.compliance);
    const double radius = model.pair().tipRadius;
    const double scale = std::max(std::abs(pullOff), 1e-6 * radius);
    return std::min(pullOff + (scale * *test::logUniform(1e-4, 1e3)), 10.0 * radius);
}

/// Going deeper the tip sinks deeper, touches over more, and once it stiffens pushes harder.
TEST(ContactExtremes, DeeperIsWiderAndFromTheLoadFoldOnStronger) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double shallow = wellAboveFold(contact, model);
        const double deep = std::min(shallow + (std::abs(shallow) * *test::logUniform(1e-6, 10.0)),
                                     20.0 * model.pair().tipRadius);
        const ContactMemory bonded{ContactBranch::Bonded};
        const ContactState first = model.equilibrium(shallow, contact.compliance, bonded);
        const ContactState second = model.equilibrium(deep, contact.compliance, bonded);
        RC_PRE(first.branch == ContactBranch::Bonded);
        const double fuzzy = 1e-12;
        RC_ASSERT(second.branch == ContactBranch::Bonded);
        RC_ASSERT(second.contactRadius >= first.contactRadius * (1.0 - fuzzy));
        RC_ASSERT(second.indentation >=
                  first.indentation - approachRounding(contact, model, second));
        if (first.stiffness > 0.0) {
            const double rounding = kRounding * forceSize(contact, model, second);
            const double jitter =
                std::abs(second.stiffness) * approachRounding(contact, model, second);
            RC_ASSERT(second.force >= first.force - rounding - jitter);
        }
    });
}

/// Central difference of the force at a held indentation, of second order.
double slopeAt(const ContactModel& model, const ContactState& state, double step) {
    const auto force = [&](double indentation) {
        return model.equilibrium(indentation, 0.0, {state.branch, state.coordinate}).force;
    };
    return (force(state.indentation + step) - force(state.indentation - step)) / (2.0 * step);
}

TEST(ContactExtremes, StiffnessIsTheSlopeOfTheForce) {
    test::checkProperty([] {
        AnyContact contact = anyDryContact();
        contact.compliance = 0.0;
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double indentation = wellAboveFold(contact, model);
        const ContactState state = model.equilibrium(indentation, 0.0, {ContactBranch::Bonded});
        RC_PRE(state.branch == ContactBranch::Bonded);
        const double step = 1e-4 * (indentation - model.pullOffApproach(0.0));
        const double coarse = slopeAt(model, state, step);
        const double fine = slopeAt(model, state, 0.5 * step);
        const double rounding =
            (kRounding * forceSize(contact, model, state) / step) +
            (kRounding * std::abs(state.stiffness) * indentationSize(contact, model, state) / step);
        const double bulk = 2.0 * contact.pair.reducedModulus * state.cohesiveRadius;
        RC_LOG() << "stiffness " << state.stiffness << " slope " << fine << '\n';
        RC_ASSERT(std::abs(fine - state.stiffness) <=
                  std::abs(coarse - fine) + rounding + (1e-6 * bulk));
    });
}

TEST(ContactExtremes, ForceIsContinuousWhileBonded) {
    test::checkProperty([] {
        const AnyContact contact = anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const double low = wellAboveFold(contact, model);
        const double high = std::min(low + (std::abs(low) * *test::logUniform(1e-3, 10.0)),
                                     20.0 * model.pair().tipRadius);
        const ContactMemory bonded{ContactBranch::Bonded};
        const ContactState deep = model.equilibrium(high, contact.compliance, bonded);
        RC_ASSERT(test::stepWithin(model, {contact.compliance, ContactBranch::Bonded}, low, high) <=
                  1e-4 * forceSize(contact, model, deep));
    });
}

}  // namespace
}  // namespace asperity
