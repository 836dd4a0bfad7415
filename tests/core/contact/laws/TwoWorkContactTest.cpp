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

TwoWorkContact rubber(double retractWork, ContactLaw law = ContactLaw::SphereJkr) {
    return {law, kRubber, retractWork};
}

TEST(TwoWorkContact, IsTheLawWhereBothWorksAreEqual) {
    for (const ContactLaw law : {ContactLaw::Jkr, ContactLaw::SphereJkr}) {
        const TwoWorkContact two = rubber(0.04, law);
        const ContactModel one(law, kRubber);
        TwoWorkMemory memory;
        ContactMemory before;
        for (int i = 0; i <= 400; ++i) {
            const double base = 1e-6 * (i <= 200 ? -1.0 + (0.01 * i) : 3.0 - (0.01 * i));
            const ContactState state = two.equilibrium(base, kLever, memory);
            const ContactState expected = one.equilibrium(base, kLever, before);
            before = expected.memory();
            EXPECT_EQ(state.branch, expected.branch) << i;
            EXPECT_NEAR(state.force, expected.force, 1e-9 * 3e-6) << i;
        }
    }
}

TEST(TwoWorkContact, HoldsItsRadiusAtAReversal) {
    const TwoWorkContact contact = rubber(0.048);
    TwoWorkMemory memory;
    const ContactState top = contact.equilibrium(0.8e-6, kLever, memory);
    const double stiffness = 2.0 * top.contactRadius * kRubber.reducedModulus;
    const double together = stiffness / (1.0 + (kLever * stiffness));
    for (const double step : {1e-12, 1e-10, 1e-9}) {
        const ContactState state = contact.equilibrium(0.8e-6 - step, kLever, memory);
        EXPECT_EQ(state.contactRadius, top.contactRadius);
        EXPECT_NEAR((top.force - state.force) / step / together, 1.0, 1e-3);
    }
    EXPECT_NEAR(contact.equilibrium(0.8e-6, kLever, memory).force, top.force, 1e-12 * top.force);
}

TEST(TwoWorkContact, ForceHasNoJumpWhileBonded) {
    const TwoWorkContact contact = rubber(0.08);
    TwoWorkMemory memory;
    double before = contact.equilibrium(1e-6, kLever, memory).force;
    for (int i = 1; i <= 1000; ++i) {
        const ContactState state = contact.equilibrium(1e-6 - (1e-9 * i), kLever, memory);
        ASSERT_EQ(state.branch, ContactBranch::Bonded);
        EXPECT_LT(before - state.force, 5.0 * 1e-9) << i;  // the lever's stiffness
        before = state.force;
    }
}

TEST(TwoWorkContact, NeverGivesEnergy) {
    const TwoWorkContact contact = rubber(0.06);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> turn(-1e-6, 1e-6);
    for (int loop = 0; loop < 50; ++loop) {
        TwoWorkMemory memory;
        double work = 0.0;
        double base = -2e-6;
        double force = 0.0;
        const auto go = [&](double target) {
            const int steps = 2000;
            const double from = base;
            for (int i = 1; i <= steps; ++i) {
                const double next = from + ((target - from) * i / steps);
                const double now = contact.equilibrium(next, kLever, memory).force;
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
    const TwoWorkContact contact = rubber(0.06);
    TwoWorkMemory memory;
    (void)contact.equilibrium(1e-6, kLever, memory);
    const double force = contact.equilibrium(0.95e-6, kLever, memory).force;
    double work = 0.0;
    double before = force;
    for (int i = 1; i <= 200; ++i) {
        const double offset = 1e-8 * std::sin(2.0 * pi * i / 200.0);
        const double now = contact.equilibrium(0.95e-6 + offset, kLever, memory).force;
        work += 0.5 * (now + before) * 1e-8 *
                (std::sin(2.0 * pi * i / 200.0) - std::sin(2.0 * pi * (i - 1) / 200.0));
        before = now;
    }
    EXPECT_NEAR(work, 0.0, 1e-9 * 1e-8 * std::abs(force));
}

TEST(TwoWorkContact, PullsOffByTheWorkOnRetract) {
    const TwoWorkContact contact = rubber(0.06, ContactLaw::Jkr);
    TwoWorkMemory memory;
    double lowest = 0.0;
    constexpr double kSoft = 1e4;
    for (int i = 0; i < 20000; ++i) {
        const double base = 0.03 - (3e-6 * i);
        lowest = std::min(lowest, contact.equilibrium(base, kSoft, memory).force);
    }
    EXPECT_EQ(memory.branch, ContactBranch::Far);
    EXPECT_NEAR(lowest / (-1.5 * pi * 0.06 * 7.5e-6), 1.0, 1e-3);
}

TEST(TwoWorkContact, RefusesOtherLawsAndLessWorkOnRetract) {
    EXPECT_THROW(rubber(0.03), Error);
    EXPECT_THROW(rubber(0.05, ContactLaw::Maugis), Error);
}

}  // namespace
}  // namespace asperity
