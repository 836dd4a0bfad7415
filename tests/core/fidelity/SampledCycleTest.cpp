#include "core/Units.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/fidelity/SampledRuns.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace asperity {
namespace {

TEST(SampledCycle, OnAPlaneIsTheCurveOfTheLaw) {
    SceneDescription description = test::plainScene();
    description.probe.mountTilt = 0.0;
    const Scene scene = buildScene(description, test::flatMap());
    const auto cycle = sampleCycle(scene, {60.0_nm, 60.0_nm}, 5.0_nN);
    ASSERT_TRUE(cycle);
    const double compliance = scene.belief.cantilever.compliance()(2, 2);
    const ContactModel& law = scene.belief.contact;
    EXPECT_NEAR(cycle->pullOffForce, -strongestPullOf(law, compliance)->state.force, 1e-15);
    EXPECT_NEAR(cycle->pullOffBase, -pullOffOf(law, compliance)->basePosition, 1e-15);
    EXPECT_NEAR(cycle->snapInBase, -snapInOf(law, compliance)->basePosition, 1e-15);
    EXPECT_NEAR(cycle->snapInForce, -snapInOf(law, compliance)->after.force, 1e-15);
    EXPECT_NEAR(-cycle->setpointBase, *basePositionAt(law, compliance, 5.0_nN), 1e-15);
    EXPECT_NEAR(cycle->retract.at(cycle->setpointBase), 5.0_nN, 1e-15);
    const double beforePullOff = cycle->pullOffBase - 1e-15;
    EXPECT_NEAR(cycle->retract.at(beforePullOff), pullOffOf(law, compliance)->before.force, 1e-12);
    EXPECT_EQ(cycle->retract.at(cycle->setpointBase - 1.0_nm), 0.0);
}

/// A tip that sticks: pushed with 2 at -2, pulled with 1 until it lets go at `off`.
SampledCycle cycleWith(double off) {
    return {.pullOffForce = 1.0,
            .pullOffBase = off,
            .snapInForce = 0.0,
            .snapInBase = -2.0,
            .setpointBase = -2.0,
            .indentation = 1.0,
            .pulled = 1.0,
            .stiffness = 1.0,
            .separationWork = 2.0,
            .setpoint = 2.0,
            .approach = ForceLine({{-2.0, 0.0}, {5.0, 0.0}}),
            .retract = ForceLine({{-2.0, -1.0}, {off, -1.0}, {off, 0.0}, {5.0, 0.0}})};
}

TEST(SampledCycle, AJumpThatComesEarlierCountsByHowMuchEarlier) {
    const QuantityErrors errors = errorsOf(cycleWith(1.99), cycleWith(2.0));
    EXPECT_NEAR(errors[JudgedQuantity::PullOffPosition], 0.01 / 4.0, 1e-12);
    EXPECT_NEAR(errors[JudgedQuantity::RunForce], 0.01 / 4.0, 1e-12) << "not its root";
    EXPECT_EQ(errors[JudgedQuantity::PullOffForce], 0.0);
}

TEST(SampledCycle, AForceThatIsLargerEverywhereCountsInFull) {
    SampledCycle changed = cycleWith(2.0);
    changed.retract = ForceLine({{-2.0, -1.1}, {2.0, -1.1}, {2.0, 0.0}, {5.0, 0.0}});
    EXPECT_NEAR(errorsOf(changed, cycleWith(2.0))[JudgedQuantity::RunForce], 0.1, 1e-12);
}

TEST(SampledCycle, EachQuantityIsJudgedByItself) {
    SampledCycle changed = cycleWith(2.0);
    changed.pullOffForce = 1.147;
    changed.stiffness = 1.02;
    changed.separationWork = 0.0;
    const QuantityErrors errors = errorsOf(changed, cycleWith(2.0));
    EXPECT_NEAR(errors[JudgedQuantity::PullOffForce], 0.147, 1e-12);
    EXPECT_NEAR(errors[JudgedQuantity::Stiffness], 0.02, 1e-12);
    EXPECT_EQ(errors[JudgedQuantity::SeparationWork], 1.0) << "there is none";
    EXPECT_EQ(errors[JudgedQuantity::RunForce], 0.0);
}

TEST(SampledCycle, WhatTheReferenceDoesNotHaveIsAllWrong) {
    SampledCycle none = cycleWith(2.0);
    none.pullOffForce = 0.0;
    EXPECT_EQ(errorsOf(cycleWith(2.0), none)[JudgedQuantity::PullOffForce], 1.0);
    EXPECT_EQ(errorsOf(none, none)[JudgedQuantity::PullOffForce], 0.0);
}

TEST(SampledCycle, AnIndentationNearZeroIsJudgedByWhatThePullOffTakesAway) {
    SampledCycle reference = cycleWith(2.0);
    reference.indentation = 1e-6;
    SampledCycle changed = reference;
    changed.indentation = 0.02;
    EXPECT_NEAR(errorsOf(changed, reference)[JudgedQuantity::Indentation], 0.2, 1e-4);
    reference.indentation = 0.5;
    changed.indentation = 0.52;
    EXPECT_NEAR(errorsOf(changed, reference)[JudgedQuantity::Indentation], 0.04, 1e-12);
}

}  // namespace
}  // namespace asperity
