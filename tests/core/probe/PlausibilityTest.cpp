#include "tests/core/probe/DecouplingSituations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::Situation;
using test::slidingSituation;

Situation acrossTheBeam() { return slidingSituation(Vector3::UnitZ(), {3e-7, 1e-6, 0.0}); }

void giveSignalsOf(Situation& situation, const Vector3& force) {
    situation.force = force;
    situation.input.signals = leverSignals(situation.lever, force);
}

TEST(Plausibility, HoldsForTheForceThatWasAssumed) {
    const Situation situation = acrossTheBeam();
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_TRUE(estimate.plausibility.holds());
    EXPECT_EQ(caseText(estimate), "regular");
}

TEST(Plausibility, FrictionDoesNotDriveTheTip) {
    Situation situation = acrossTheBeam();
    giveSignalsOf(situation, {0.0, 6_nN, 20_nN});  // along +y, as the tip moves
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_TRUE(estimate.plausibility.pushesAlong);
    EXPECT_EQ(caseText(estimate).find("regular|pushes_along"), 0U);
}

TEST(Plausibility, FrictionDoesNotExceedItsLaw) {
    Situation situation = acrossTheBeam();
    giveSignalsOf(situation, {0.0, -60_nN, 20_nN});
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_TRUE(estimate.plausibility.excessFriction);
    EXPECT_FALSE(estimate.plausibility.pushesAlong);
    EXPECT_NE(caseText(estimate).find("excess_friction"), std::string::npos);
}

TEST(Plausibility, TheSampleMayNotBeWhatTheModelSays) {
    Situation situation = acrossTheBeam();
    giveSignalsOf(situation, 4.0 * situation.force);
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_TRUE(estimate.plausibility.contradictsModel);
    EXPECT_NE(caseText(estimate).find("contradicts_model"), std::string::npos);
}

TEST(Plausibility, SaysNothingOfFrictionAtRest) {
    Situation situation = acrossTheBeam();
    situation.input.velocity = Vector3::Zero();
    giveSignalsOf(situation, {0.0, 4_nN, 20_nN});
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_TRUE(estimate.plausibility.holds());
    EXPECT_EQ(caseText(estimate), "no_sliding");
}

/// Pulled so hard that mu N + tau A < 0, the tip slides without friction, not with a negative one.
TEST(Plausibility, AdhesionLeavesNoNegativeFriction) {
    Situation situation = slidingSituation(Vector3::UnitZ(), {1e-6, 0.0, 0.0});
    situation.input.normalForceModel = -20_nN;
    giveSignalsOf(situation, {0.0, 0.0, -20_nN});  // along the beam only the law knows Fx
    const ForceEstimate estimate = estimateForce(situation.lever, situation.input);
    EXPECT_LT((estimate.force - situation.force).norm(), 1e-3_nN);
    EXPECT_TRUE(estimate.plausibility.holds());
}

/// Through mu N + tau A = 0 the estimate goes on without a jump, also where the signals contradict
/// the model.
TEST(Plausibility, FadesTheFrictionLawWithoutAJump) {
    Situation situation = slidingSituation(Vector3(0.2, 0.0, 1.0), {1e-6, 2e-8, 0.0});
    situation.input.normalForceSigma = 1_nN;
    situation.input.shearStrength = 50_MPa;
    situation.input.contactArea = 2e-17;
    Vector3 before = Vector3::Zero();
    for (int i = 0; i <= 4000; ++i) {
        situation.input.normalForceModel = 4_nN - i * 3e-12;
        const Vector3 force = estimateForce(situation.lever, situation.input).force;
        if (i > 0) {
            ASSERT_LT((force - before).norm(), 0.05_nN) << i;
        }
        before = force;
    }
}

}  // namespace
}  // namespace asperity
