#include "core/contact/laws/TwoWorkContact.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace asperity {
namespace {

using std::numbers::pi;

constexpr ContactPair kRubber{.tipRadius = 7.5e-6, .reducedModulus = 2e6, .workOfAdhesion = 0.04};
constexpr double kLever = 0.2;  // compliance [m/N]

ContactModel rubber(double retractWork, ContactLaw law = ContactLaw::SphereJkr) {
    return {law, kRubber, {.adhesionRatio = retractWork / kRubber.workOfAdhesion}};
}

/// The next state of a contact that is moved on.
ContactState moved(const ContactModel& contact, double approach, ContactMemory& memory,
                   double compliance = kLever) {
    const ContactState state = contact.equilibrium(approach, compliance, memory);
    memory = state.memory();
    return state;
}

TEST(TwoWorkContact, IsTheLawWhereBothWorksAreEqual) {
    for (const ContactLaw law : {ContactLaw::Jkr, ContactLaw::SphereJkr}) {
        const ContactModel two = rubber(0.04, law);
        const ContactModel one(law, kRubber);
        ContactMemory memory;
        ContactMemory before;
        for (int i = 0; i <= 400; ++i) {
            const double base = 1e-6 * (i <= 200 ? -1.0 + (0.01 * i) : 3.0 - (0.01 * i));
            const ContactState state = moved(two, base, memory);
            const ContactState expected = one.equilibrium(base, kLever, before);
            before = expected.memory();
            EXPECT_EQ(state.branch, expected.branch) << i;
            EXPECT_NEAR(state.force, expected.force, 1e-9 * 3e-6) << i;
        }
    }
}

TEST(TwoWorkContact, HoldsItsRadiusAtAReversal) {
    const ContactModel contact = rubber(0.048);
    ContactMemory memory;
    const ContactState top = moved(contact, 0.8e-6, memory);
    const double stiffness = 2.0 * top.contactRadius * kRubber.reducedModulus;
    const double together = stiffness / (1.0 + (kLever * stiffness));
    for (const double step : {1e-12, 1e-10, 1e-9}) {
        const ContactState state = moved(contact, 0.8e-6 - step, memory);
        EXPECT_EQ(state.contactRadius, top.contactRadius);
        EXPECT_NEAR((top.force - state.force) / step / together, 1.0, 1e-3);
    }
    EXPECT_NEAR(moved(contact, 0.8e-6, memory).force, top.force, 1e-12 * top.force);
}

TEST(TwoWorkContact, ForceHasNoJumpWhileBonded) {
    const ContactModel contact = rubber(0.08);
    ContactMemory memory;
    double before = moved(contact, 1e-6, memory).force;
    for (int i = 1; i <= 1000; ++i) {
        const ContactState state = moved(contact, 1e-6 - (1e-9 * i), memory);
        ASSERT_EQ(state.branch, ContactBranch::Bonded);
        EXPECT_LT(before - state.force, 5.0 * 1e-9) << i;  // the lever's stiffness
        before = state.force;
    }
}

TEST(TwoWorkContact, NeverGivesEnergy) {
    const ContactModel contact = rubber(0.06);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> turn(-1e-6, 1e-6);
    for (int loop = 0; loop < 50; ++loop) {
        ContactMemory memory;
        double work = 0.0;
        double base = -2e-6;
        double force = 0.0;
        const auto go = [&](double target) {
            const int steps = 2000;
            const double from = base;
            for (int i = 1; i <= steps; ++i) {
                const double next = from + ((target - from) * i / steps);
                const double now = moved(contact, next, memory).force;
                work += 0.5 * (now + force) * (next - base);
                base = next;
                force = now;
            }
        };
        for (int i = 0; i < 6; ++i) {
            go(turn(random));
        }
        go(-2e-6);
        EXPECT_EQ(force, 0.0);
        EXPECT_GE(work, -1e-18) << loop;
    }
}

TEST(TwoWorkContact, SmallMotionsLoseNothing) {
    const ContactModel contact = rubber(0.06);
    ContactMemory memory;
    (void)moved(contact, 1e-6, memory);
    const double force = moved(contact, 0.95e-6, memory).force;
    double work = 0.0;
    double before = force;
    for (int i = 1; i <= 200; ++i) {
        const double offset = 1e-8 * std::sin(2.0 * pi * i / 200.0);
        const double now = moved(contact, 0.95e-6 + offset, memory).force;
        work += 0.5 * (now + before) * 1e-8 *
                (std::sin(2.0 * pi * i / 200.0) - std::sin(2.0 * pi * (i - 1) / 200.0));
        before = now;
    }
    EXPECT_NEAR(work, 0.0, 1e-9 * 1e-8 * std::abs(force));
}

TEST(TwoWorkContact, PullsOffByTheWorkOnRetract) {
    const ContactModel contact = rubber(0.06, ContactLaw::Jkr);
    ContactMemory memory;
    double lowest = 0.0;
    constexpr double kSoft = 1e4;
    for (int i = 0; i < 20000; ++i) {
        const double base = 0.03 - (3e-6 * i);
        lowest = std::min(lowest, moved(contact, base, memory, kSoft).force);
    }
    EXPECT_EQ(memory.branch, ContactBranch::Far);
    EXPECT_NEAR(lowest / (-1.5 * pi * 0.06 * 7.5e-6), 1.0, 1e-3);
}

TEST(TwoWorkContact, RefusesOtherLawsAndLessWorkOnRetract) {
    EXPECT_THROW(rubber(0.03), Error);
    EXPECT_THROW(
        ContactModel(ContactLaw::Jkr, kRubber,
                     {.adhesionRatio = 1.2, .meniscus = {.surfaceTension = 0.07, .range = 2e-9}}),
        Error);
    EXPECT_EQ(rubber(0.05, ContactLaw::Maugis).adhesionRatio(), 1.0);
}

TEST(TwoWorkContact, HoldsOnAnotherTipAndScale) {
    // Lengths times 3, forces times 9: the same contact.
    const ContactModel small = rubber(0.06);
    ContactPair large = kRubber;
    large.tipRadius *= 3.0;
    large.workOfAdhesion *= 3.0;
    const ContactModel scaled = small.withPair(large);
    ContactMemory one;
    ContactMemory other;
    for (int i = 0; i <= 600; ++i) {
        const double base = 1e-6 * (i <= 200 ? -1.0 + (0.01 * i) : 3.0 - (0.01 * i));
        const double force = moved(small, base, one).force;
        EXPECT_NEAR(moved(scaled, 3.0 * base, other, kLever / 3.0).force, 9.0 * force,
                    1e-6 * std::abs(force) + 1e-15)
            << i;
    }
}

TEST(TwoWorkContact, EndsWhereTheWorkOnRetractSays) {
    const ContactModel contact = rubber(0.06);
    const ContactModel opening = contact.shrinking();
    EXPECT_EQ(opening.pair().workOfAdhesion, 0.06);
    EXPECT_EQ(contact.pullOffApproach(kLever), opening.pullOffApproach(kLever));
    EXPECT_EQ(contact.lastBonded(kLever).force, opening.lastBonded(kLever).force);
    EXPECT_EQ(contact.jumpInApproach(kLever),
              ContactModel(contact.law(), kRubber).jumpInApproach(kLever));
    const ContactState gone = contact.equilibrium(-3e-6, kLever, kBondedMemory);
    EXPECT_TRUE(gone.jumped);
    EXPECT_GT(gone.energyLost, 0.0);
}

}  // namespace
}  // namespace asperity
