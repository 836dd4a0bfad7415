#include "core/experiment/TrialRun.h"

#include "core/Units.h"
#include "core/scene/Scene.h"
#include "tests/core/experiment/SmallStudy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity::test {
namespace {

/// A task of the small study on one of its materials, by a usual person.
DoneTrial trialOf(const Study& study, std::size_t task, std::size_t material,
                  const TrialWatch& watch = {}) {
    const Scene scene = buildScene(sceneOf(study, material, 0));
    PlannedTrial plan{.number = 1, .participant = 1, .task = task, .material = material, .seed = 4};
    plan.height = study.tasks[task].kind == TaskKind::Below ? -study.tasks[task].nearest
                                                            : study.tasks[task].nearest;
    return runTrial({.study = study, .scene = scene, .person = {}, .bench = {.arm = kNormalGrip}},
                    plan, watch);
}

TEST(TrialRun, EndsNearTheTarget) {
    const Study study = smallStudy();
    for (std::size_t task = 0; task < study.tasks.size(); ++task) {
        for (const std::size_t material : study.tasks[task].materials) {
            const DoneTrial done = trialOf(study, task, material);
            EXPECT_TRUE(done.record.counts());
            EXPECT_FALSE(done.record.timedOut);
            EXPECT_LT(done.record.error, 2.0_nm) << task << ' ' << material;
            EXPECT_GT(done.record.time, 1.0);
            EXPECT_EQ(done.record.time, done.moments.back().time);
            EXPECT_GT(done.record.coupling.stiffness, 0.0);
        }
    }
}

TEST(TrialRun, IsTheSameToTheBit) {
    const DoneTrial one = trialOf(smallStudy(), 1, 0);
    const DoneTrial other = trialOf(smallStudy(), 1, 0);
    ASSERT_EQ(one.moments.size(), other.moments.size());
    for (std::size_t i = 0; i < one.moments.size(); ++i) {
        EXPECT_EQ(one.moments[i].tip, other.moments[i].tip);
        EXPECT_EQ(one.moments[i].deviceForce, other.moments[i].deviceForce);
    }
}

TEST(TrialRun, BeginsAboveTheMiddleAndKeepsAHundredMomentsASecond) {
    const Study study = smallStudy();
    const DoneTrial done = trialOf(study, 1, 1);
    EXPECT_NEAR(done.record.start.x(), 200.0_nm, 0.5_nm);
    EXPECT_NEAR(done.record.start.y(), 200.0_nm, 0.5_nm);
    EXPECT_NEAR(done.record.start.z(), study.startHeight, 0.5_nm);
    EXPECT_NEAR(static_cast<double>(done.moments.size()), 100.0 * done.record.time, 2.0);
}

TEST(TrialRun, APressInTakesForceAndTaskAboveNone) {
    const DoneTrial pressed = trialOf(smallStudy(), 2, 1);
    EXPECT_GT(pressed.record.largestForce, 5.0_nN);
    EXPECT_LT(trialOf(smallStudy(), 0, 1).record.largestForce, 2.0_nN);
}

TEST(TrialRun, AFaultEndsIt) {
    Study study = smallStudy();
    study.scene.settings.governor.maxDeviceSpeed = 0.02;  // slower than a hand that reaches
    const DoneTrial done = trialOf(study, 1, 1);
    EXPECT_EQ(done.record.fault, Fault::VelocityTrip);
    EXPECT_FALSE(done.record.counts());
    EXPECT_LT(done.record.time, 2.0);
}

TEST(TrialRun, TheTimeLimitEndsIt) {
    Study study = smallStudy();
    study.timeLimit = 1.0;
    const DoneTrial done = trialOf(study, 1, 1);
    EXPECT_TRUE(done.record.timedOut);
    EXPECT_TRUE(done.record.counts());
    EXPECT_NEAR(done.record.time, 1.0, 1e-3);
}

TEST(TrialRun, AWatchSeesEveryTickFromTheBeginning) {
    long begins = 0;
    std::vector<double> times;
    const DoneTrial done =
        trialOf(smallStudy(), 1, 1,
                {.begin = [&](const TickMemory& memory) { begins += memory.started ? 1 : 0; },
                 .tick = [&](const TickSample& sample) { times.push_back(sample.time); }});
    EXPECT_EQ(begins, 1);
    EXPECT_NEAR(static_cast<double>(times.size()), 1000.0 * done.record.time, 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(times));
}

TEST(TrialRun, WithoutACouplingTheDeviceFeelsTheSampleItself) {
    Study study = smallStudy();
    study.aids.coupling = false;
    const DoneTrial done = trialOf(study, 1, 1);
    EXPECT_EQ(done.record.coupling.stiffness, 0.0);
    EXPECT_TRUE(done.record.counts());
}

TEST(TrialRun, WithoutForcesTheDeviceGivesNone) {
    Study study = smallStudy();
    study.aids.forces = false;
    for (const TrialMoment& moment : trialOf(study, 1, 1).moments) {
        EXPECT_EQ(moment.deviceForce, Vector3::Zero());
    }
}

TEST(TrialRun, AGuideIsThroughTheTarget) {
    Study study = smallStudy();
    study.aids.guide = FixtureKind::Point;
    const Scene scene = buildScene(sceneOf(study, 1, 0));
    const Vector3 target(230.0_nm, 220.0_nm, 0.0);
    const Settings settings = trialSettings(study, scene, {}, target);
    EXPECT_EQ(settings.guide.kind, FixtureKind::Point);
    EXPECT_EQ(settings.guide.point, target);
    EXPECT_LE(trialOf(study, 1, 1).record.error, trialOf(smallStudy(), 1, 1).record.error + 0.3_nm);
}

}  // namespace
}  // namespace asperity::test
