#include "core/probe/TimedCurve.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr ContactPair kSoft{.tipRadius = 5e-6, .reducedModulus = 1333.0};
constexpr double kSoftLever = 20.0;  // [m/N]

TEST(TimedCurve, OfASlowBaseIsThatOfTheLaw) {
    const ContactModel model(ContactLaw::Hertz, kSoft);
    const TimeTerms terms{
        .relaxingShare = 1.5, .relaxationTime = 0.1, .drag = 2e-11, .dragOffset = 0.5e-6};
    const ForceCurve slow = timedCurve(
        model, terms, kSoftLever,
        {.way = {.farthest = -1.0_um, .deepest = 2.0_um, .points = 301}, .speed = 1e-12});
    ASSERT_EQ(slow.approach.size(), 301U);
    ASSERT_EQ(slow.retract.size(), 301U);
    for (const auto* way : {&slow.approach, &slow.retract}) {
        for (const ForceCurvePoint& point : *way) {
            const double force = model.equilibrium(point.basePosition, kSoftLever, {}).force;
            EXPECT_NEAR(point.state.force, force, 1e-5 * 100e-12) << point.basePosition;
        }
    }
    EXPECT_FALSE(slow.snapIn || slow.pullOff);
}

TEST(TimedCurve, OfAFastBaseIsStiffAndLosesEnergy) {
    const ContactModel model(ContactLaw::Hertz, kSoft);
    const TimeTerms terms{.relaxingShare = 1.5, .relaxationTime = 0.1};
    const ForceCurve curve = timedCurve(
        model, terms, kSoftLever,
        {.way = {.farthest = -0.5_um, .deepest = 2.0_um, .points = 251}, .speed = 10e-6});
    EXPECT_GT(curve.approach.back().state.force,
              1.2 * model.equilibrium(2.0_um, kSoftLever, {}).force);
    double work = 0.0;
    for (const auto* way : {&curve.approach, &curve.retract}) {
        for (std::size_t i = 1; i < way->size(); ++i) {
            work += 0.5 * ((*way)[i].state.force + (*way)[i - 1].state.force) *
                    ((*way)[i].basePosition - (*way)[i - 1].basePosition);
        }
    }
    EXPECT_GT(work, 0.0);
}

TEST(TimedCurve, EndsItsApproachAtTheSetpoint) {
    const ContactModel model(ContactLaw::Hertz, kSoft);
    const TimeTerms terms{.relaxingShare = 1.5, .relaxationTime = 0.1};
    const ForceCurve curve =
        timedCurve(model, terms, kSoftLever,
                   {.way = {.farthest = -0.5_um, .deepest = 2.0_um, .points = 2001},
                    .speed = 10e-6,
                    .setpoint = 1.0_nN});
    EXPECT_NEAR(curve.approach.back().state.force, 1.0_nN, 0.01_nN);
    EXPECT_LT(curve.approach.back().basePosition, 2.0_um);
    EXPECT_NEAR(curve.retract.back().basePosition, -0.5_um, 1e-9);
}

}  // namespace
}  // namespace asperity
