#include "core/contact/laws/ForceCurve.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr ContactPair kOxide{.tipRadius = 15e-9, .reducedModulus = 53.39e9, .workOfAdhesion = 0.2};
constexpr ContactPair kColloid{.tipRadius = 5e-6, .reducedModulus = 50e9, .workOfAdhesion = 0.05};

double strongestOf(const std::vector<ForceCurvePoint>& way) {
    double strongest = 0.0;
    for (const ForceCurvePoint& point : way) {
        strongest = std::max(strongest, -point.state.force);
    }
    return strongest;
}

/// JKR without a lever pulls by 5/6 pi w R when it comes off, by 3/2 before.
TEST(ForceCurve, HasTheStrongestPullBesideTheForceAtPullOff) {
    const double unit = std::numbers::pi * kOxide.workOfAdhesion * kOxide.tipRadius;
    const ContactModel jkr(ContactLaw::Jkr, kOxide);
    for (const double compliance : {0.0, 1.0 / 200.0, 2.0}) {
        const ForceCurve curve = forceCurve(jkr, compliance, curvePlan(jkr, compliance));
        ASSERT_TRUE(curve.strongest && curve.pullOff);
        EXPECT_NEAR(curve.strongest->state.force, -1.5 * unit, 1e-6 * unit);
        EXPECT_NEAR(strongestOf(curve.retract), 1.5 * unit, 1e-6 * unit) << "among the points";
        EXPECT_GE(curve.strongest->basePosition, curve.pullOff->basePosition);
    }
    const ContactModel hertz(ContactLaw::Hertz, kOxide);
    EXPECT_FALSE(strongestPullOf(hertz, 0.1));
}

TEST(ForceCurve, FindsTheStrongestPullOfAColloidWithFewPoints) {
    const double unit = std::numbers::pi * kColloid.workOfAdhesion * kColloid.tipRadius;
    for (const ContactLaw law : {ContactLaw::Split, ContactLaw::Maugis, ContactLaw::Jkr}) {
        const ContactModel model(law, kColloid);
        for (const double stiffness : {1.0, 40.0, 1000.0, 1e6}) {
            ForceCurvePlan plan = curvePlan(model, 1.0 / stiffness);
            plan.points = 12;
            EXPECT_GT(strongestOf(forceCurve(model, 1.0 / stiffness, plan).retract), 1.49 * unit)
                << keyOf(law) << ' ' << stiffness;
        }
    }
}

/// No two neighbors, but for the sides of a jump, are farther apart along the drawn curve than a
/// few times what all of it is on average.
TEST(ForceCurve, PlacesItsPointsAlongTheCurve) {
    const ContactModel model(ContactLaw::Split, kColloid);
    ForceCurvePlan plan = curvePlan(model, 1e-3);
    plan.points = 200;
    const ForceCurve curve = forceCurve(model, 1e-3, plan);
    ASSERT_EQ(curve.retract.size(), 202U);
    const double range = plan.deepest - plan.farthest;
    const auto forces = [](const ForceCurvePoint& point) { return point.state.force; };
    const double forceRange = std::ranges::max(curve.retract, {}, forces).state.force -
                              std::ranges::min(curve.retract, {}, forces).state.force;
    for (std::size_t i = 1; i < curve.retract.size(); ++i) {
        const double across = curve.retract[i - 1].basePosition - curve.retract[i].basePosition;
        EXPECT_GE(across, 0.0);
        const double up = curve.retract[i].state.force - curve.retract[i - 1].state.force;
        if (across > 0.0) {
            EXPECT_LT(std::hypot(across / range, up / forceRange), 6.0 / 200.0) << i;
        }
    }
}

TEST(ForceCurve, ThatDoesNotReachTheJumpsHasNone) {
    const ContactModel model(ContactLaw::Split, kOxide);
    const double compliance = 1.0 / 14.0;
    const ForceCurve far = forceCurve(model, compliance, {-20.0_nm, -5.0_nm, 10});
    ASSERT_EQ(far.approach.size(), 10U);
    ASSERT_EQ(far.retract.size(), 10U);
    EXPECT_EQ(far.retract.front().state.branch, ContactBranch::Far);
    const ForceCurve inside = forceCurve(model, compliance, {-1.0_nm, -0.6_nm, 10});
    EXPECT_EQ(inside.retract.front().state.branch, ContactBranch::Far)
        << "between pull-off and snap-in, from afar";
    const ForceCurve deep = forceCurve(model, compliance, {1.0_nm, 2.0_nm, 10});
    ASSERT_EQ(deep.approach.size(), 10U);
    EXPECT_EQ(deep.approach.front().state.branch, ContactBranch::Bonded);
    EXPECT_EQ(deep.retract.back().state.branch, ContactBranch::Bonded);
    EXPECT_NEAR(deep.approach.front().state.force, deep.retract.back().state.force, 1e-18);
}

TEST(ForceCurve, KnowsWhereATipPushesWithAForce) {
    for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Jkr, ContactLaw::SphereSplit}) {
        const ContactModel model(law, kOxide);
        for (const double force : {1e-12, 5.0_nN, 1e-6}) {
            const auto position = basePositionAt(model, 0.1, force);
            ASSERT_TRUE(position);
            EXPECT_NEAR(model.equilibrium(*position, 0.1, kBondedMemory).force, force,
                        1e-9 * force + 1e-18);
        }
    }
}

}  // namespace
}  // namespace asperity
