#include "core/Units.h"
#include "core/experiment/TrialRun.h"

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

const PlannedTrial kPlan{.number = 3, .participant = 1};
const Vector3 kTarget(30.0_nm, 0.0, 0.0);
const Vector3 kHere = Vector3::Zero();

TickSample tickAt(double time, double force = 0.0) {
    TickSample sample;
    sample.time = time;
    sample.output.estimate.force = {0.0, 0.0, force};
    return sample;
}

Snapshot frameAt(double time, const Vector3& tip) {
    Snapshot frame;
    frame.sample = tickAt(time);
    frame.sample.output.model.tip = tip;
    return frame;
}

TEST(WatchedTrial, IsMeasuredFromItsFirstFrameToItsLastOne) {
    WatchedTrial trial(kPlan, kTarget, frameAt(10.0, {0.0, 0.0, 40.0_nm}));
    trial.show(frameAt(10.5, {10.0_nm, 0.0, 0.0}));
    trial.show(frameAt(12.0, {30.0_nm, 0.0, 1.0_nm}));
    const DoneTrial done = trial.end({});
    EXPECT_EQ(done.record.plan, kPlan);
    EXPECT_EQ(done.record.time, 2.0);
    EXPECT_NEAR(done.record.error, 1.0_nm, 1e-18);
    EXPECT_NEAR(done.record.errorPercent, 2.0, 1e-9);  // of 50 nm
    EXPECT_EQ(done.moments.size(), 3U);
    EXPECT_TRUE(done.record.counts());
}

TEST(WatchedTrial, TheTrueTipOfASimulatedInstrumentCounts) {
    WatchedTrial trial(kPlan, kTarget, frameAt(0.0, {0.0, 0.0, 40.0_nm}));
    Snapshot last = frameAt(1.0, kTarget);
    last.trueTip = Vector3(33.0_nm, 0.0, 0.0);
    trial.show(last);
    const DoneTrial done = trial.end({});
    EXPECT_NEAR(done.record.error, 3.0_nm, 1e-18);
    EXPECT_EQ(done.moments.back().shown, kTarget);
}

TEST(WatchedTrial, AForceBetweenFramesIsOfTheFrameAfterIt) {
    WatchedTrial trial(kPlan, kTarget, frameAt(1.0, kHere));
    trial.take(tickAt(0.9, 9.0_nN));   // before it began
    trial.take(tickAt(1.01, 5.0_nN));  // and gone again
    trial.take(tickAt(1.02, -6.0_nN));
    trial.take(tickAt(1.04, 8.0_nN));  // after the newest frame
    trial.show(frameAt(1.03, kHere));
    EXPECT_EQ(trial.end({}).record.largestForce, 6.0_nN);
    trial.show(frameAt(1.05, kHere));
    const DoneTrial done = trial.end({});
    EXPECT_EQ(done.record.largestForce, 8.0_nN);
    EXPECT_EQ(done.moments[1].largestForce, 6.0_nN);
}

TEST(WatchedTrial, AFrameWithoutATickIsNoMoment) {
    WatchedTrial trial(kPlan, kTarget, frameAt(1.0, kHere));
    trial.show(frameAt(1.0, kHere));
    EXPECT_EQ(trial.end({}).moments.size(), 1U);
}

TEST(WatchedTrial, SaysWhatEndedItAndUnderWhichKnobs) {
    WatchedTrial trial(kPlan, kTarget, frameAt(0.0, kHere));
    Snapshot last = frameAt(1.0, kHere);
    last.sample.output.fault = Fault::VelocityTrip;
    last.sample.input.settings.positionGain = 1e-6;
    last.sample.input.settings.coupling.stiffness = 200.0;
    trial.show(last);
    EXPECT_EQ(trial.fault(), Fault::VelocityTrip);
    const TrialRecord record = trial.end({.timedOut = true, .struckOut = "sneezed"}).record;
    EXPECT_EQ(record.fault, Fault::VelocityTrip);
    EXPECT_TRUE(record.timedOut);
    EXPECT_EQ(record.struckOut, "sneezed");
    EXPECT_FALSE(record.counts());
    EXPECT_EQ(record.scale.positionGain, 1e-6);
    EXPECT_EQ(record.coupling.stiffness, 200.0);
}

}  // namespace
}  // namespace asperity::test
