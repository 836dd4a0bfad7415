#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/AnyContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using test::AnyContact;

/// Both jumps of a lever.
struct Jumps {
    double in;   ///< approach of the snap-in [m]
    double out;  ///< approach of the pull-off [m]
    ContactState landed;
    ContactState gone;
};

Jumps jumpsOf(const ContactModel& model, double compliance) {
    const double in = model.jumpInApproach(compliance);
    const double out = model.pullOffApproach(compliance);
    const double margin = (1e-13 * (std::abs(in) + std::abs(out))) + 1e-30;
    return {in, out, model.equilibrium(in + margin, compliance, {ContactBranch::Far}),
            model.equilibrium(out - margin, compliance, {ContactBranch::Bonded})};
}

/// Work that the base does on the lever along one branch, on a grid that is fine at both ends,
/// where the force may be a square root of the distance.
double workAlong(const AnyContact& contact, const ContactModel& model, ContactBranch branch,
                 const Jumps& jumps) {
    constexpr int kCells = 600;
    const double span = jumps.in - jumps.out;
    double work = 0.0;
    for (int i = 0; i < kCells; ++i) {
        const double u = (i + 0.5) / kCells;
        const double approach = jumps.out + (span * u * u * (3.0 - (2.0 * u)));
        const double width = span * 6.0 * u * (1.0 - u) / kCells;
        work += model.equilibrium(approach, contact.compliance, {branch}).force * width;
    }
    return work;
}

void expectLoop(const AnyContact& contact) {
    const ContactModel model = contact.model();
    RC_LOG() << contact << '\n';
    const Jumps jumps = jumpsOf(model, contact.compliance);
    RC_PRE(jumps.out < jumps.in);
    const double pulled = workAlong(contact, model, ContactBranch::Bonded, jumps);
    const double loop = workAlong(contact, model, ContactBranch::Far, jumps) - pulled;
    const double lost = jumps.landed.energyLost + jumps.gone.energyLost;
    const ContactState last = model.lastBonded(contact.compliance);
    // Energies are known to the rounding of what cancels in them.
    const double canceled =
        1e-11 * (std::abs(last.force) + forceSize(contact, model, jumps.landed)) *
        (indentationSize(contact, model, jumps.landed) + indentationSize(contact, model, last) +
         (contact.compliance * forceSize(contact, model, last)));
    const Meniscus& water = contact.options.meniscus;
    const double rounding = canceled + (1e-14 * water.pull(contact.pair.tipRadius) * water.range);
    RC_LOG() << "loop " << loop << " lost in " << jumps.landed.energyLost << " out "
             << jumps.gone.energyLost << " rounding " << rounding << '\n';
    RC_ASSERT(loop >= -rounding);
    RC_ASSERT(std::abs(lost - loop) <= (3e-4 * std::abs(pulled)) + rounding);
}

/// Approach and retract: what the base puts in and does not get back is what the jumps report.
TEST(ContactLoop, LosesWhatTheJumpsReportAndMakesNothing) {
    test::checkProperty([] { expectLoop(test::anyDryContact()); });
}

TEST(ContactLoop, LosesWhatTheJumpsReportUnderWater) {
    test::checkProperty([] {
        AnyContact contact = test::anyDryContact();
        contact.options.meniscus = test::anyMeniscus();
        expectLoop(contact);
    });
}

TEST(ContactLoop, JumpsOnlyWhereTheForceDoes) {
    test::checkProperty([] {
        const AnyContact contact = test::anyContact();
        const ContactModel model = contact.model();
        RC_LOG() << contact << '\n';
        const Jumps jumps = jumpsOf(model, contact.compliance);
        RC_ASSERT(jumps.gone.branch == ContactBranch::Far);
        RC_ASSERT(jumps.landed.branch == ContactBranch::Bonded);
        const ContactState last = model.lastBonded(contact.compliance);
        const ContactState before =
            model.equilibrium(jumps.in, contact.compliance, {ContactBranch::Far});
        const double rounding =
            1e-9 * (forceSize(contact, model, jumps.landed) + forceSize(contact, model, last));
        RC_ASSERT(before.branch == ContactBranch::Far);
        RC_ASSERT(!jumps.gone.jumped || last.force < jumps.gone.force + rounding);
        RC_ASSERT(jumps.gone.jumped || last.force > jumps.gone.force - rounding);
        RC_ASSERT(!jumps.landed.jumped || jumps.landed.force < before.force + rounding);
        RC_ASSERT(jumps.landed.jumped || jumps.landed.force > before.force - rounding);
    });
}

}  // namespace
}  // namespace asperity
