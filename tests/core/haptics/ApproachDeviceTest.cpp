#include "core/Units.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace asperity {
namespace {

constexpr double kDuration = 4.0;  // [s]

std::vector<TickSample> approached(const Scene& scene, ApproachDevice& device) {
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    std::vector<TickSample> samples;
    runVirtually(scene, device, afm, 4001,
                 [&](const TickSample& sample) { samples.push_back(sample); });
    return samples;
}

std::vector<TickSample> approached(const Scene& scene) {
    ApproachDevice device(planApproach(scene, {.duration = kDuration}),
                          scene.settings.positionGain);
    std::vector<TickSample> samples = approached(scene, device);
    EXPECT_TRUE(device.hasEngaged());
    EXPECT_EQ(device.phase(), ApproachPhase::Done) << "not back in time";
    return samples;
}

double strongestPush(const std::vector<TickSample>& samples) {
    double strongest = 0.0;
    for (const TickSample& sample : samples) {
        strongest = std::max(strongest, sample.output.model.force.z());
    }
    return strongest;
}

TEST(ApproachDevice, EndsAtTheSetpointStraightBelowItsStart) {
    for (const double setpoint : {0.5_nN, 5.0_nN, 20.0_nN}) {
        SceneDescription description = test::plainScene();
        description.setpoint = setpoint;
        const Scene scene = buildScene(description, test::hillyMap());
        const std::vector<TickSample> samples = approached(scene);
        EXPECT_NEAR(strongestPush(samples), setpoint, 0.3_nN + 0.02 * setpoint);
        const Vector3& start = samples.front().output.base.position;
        for (const TickSample& sample : samples) {
            ASSERT_EQ(sample.output.base.position.head<2>(), start.head<2>());
        }
        EXPECT_EQ(samples.back().output.base.position, start);
        EXPECT_EQ(samples.back().output.region(), TipRegion::Far) << "pulled off";
    }
}

/// Noise ended the descent early, by one to three of its deviations.
TEST(ApproachDevice, EngagesAtTheSetpointOnAverage) {
    for (const double noise : {1e-7, 4e-7}) {
        RunningMoments forces;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            SceneDescription description = test::plainScene();
            description.signalSigma = noise;
            description.truth.signalNoise = noise;
            description.truth.noiseSeed = seed;
            const Scene scene = buildScene(description, test::flatMap());
            ApproachDevice device(planApproach(scene, {.duration = kDuration}),
                                  scene.settings.positionGain);
            SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
            std::optional<double> engaged;
            runVirtually(scene, device, afm, 4001, [&](const TickSample&) {
                if (!engaged && device.phase() == ApproachPhase::Dwell) {
                    engaged = afm.trueState().force.z();
                }
            });
            ASSERT_TRUE(engaged);
            forces.add(*engaged);
        }
        EXPECT_LT(std::abs(forces.mean() - 5.0_nN), 4.0 * forces.meanDeviation()) << noise;
        EXPECT_LT(forces.deviation(), 0.2_nN) << noise;
    }
}

TEST(ApproachDevice, GoesAsDeepAsASoftSampleHoldsTheCone) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 15.0_nm;
    description.tip.coneHalfAngle = 0.35;
    description.sample.material.elastic = {.youngsModulus = 1.5e6, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.02;
    description.truth.material = description.sample.material;
    description.setpoint = 0.2_nN;
    description.signalSigma = 1e-9;
    description.truth.signalNoise = 1e-9;
    (void)approached(buildScene(description, test::flatMap()));
}

// What the sample is decides, not what the scene takes it to be.
TEST(ApproachDevice, FollowsTheMeasuredForceWhereTheSampleIsNotAsBelieved) {
    SceneDescription description = test::plainScene();
    description.truth.material.elastic.youngsModulus *= 0.5;
    const Scene scene = buildScene(description, test::flatMap());
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    ApproachDevice device(planApproach(scene, {.duration = kDuration}),
                          scene.settings.positionGain);
    double strongest = 0.0;
    runVirtually(scene, device, afm, 4001, [&](const TickSample&) {
        strongest = std::max(strongest, afm.trueState().force.z());
    });
    EXPECT_NEAR(strongest, scene.description.setpoint, 0.5_nN);
}

/// The force along z differs from it on a slope; a feedback that takes over holds the bending.
TEST(ApproachDevice, CountsWhatTheBendingShowsWhereItIsToldTo) {
    SceneDescription description = test::plainScene();
    description.probe.mountTilt = 0.2;
    const Scene scene = buildScene(description, test::hillyMap());
    const Vector3 axis = bendingAxis(scene.belief.cantilever);
    PlannedApproach planned =
        planApproach(scene, {.duration = kDuration, .position = Vector2(40.0_nm, 50.0_nm)});
    for (const bool counts : {false, true}) {
        planned.plan.axis = counts ? axis : Vector3::UnitZ();
        ApproachDevice device(planned, scene.settings.positionGain);
        SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
        std::optional<Vector3> engaged;
        runVirtually(scene, device, afm, 4001, [&](const TickSample&) {
            if (!engaged && device.phase() == ApproachPhase::Dwell) {
                engaged = afm.trueState().force;
            }
        });
        ASSERT_TRUE(engaged);
        EXPECT_NEAR(planned.plan.axis.dot(*engaged), scene.description.setpoint, 0.15_nN);
        EXPECT_GT(std::abs(axis.dot(*engaged) - engaged->z()), 0.25_nN);
    }
}

TEST(ApproachDevice, MovesByItsGainFromWhereTheDeviceBeforeWas) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    constexpr double kGain = 0.5;
    const Vector3 device(1.0, 2.0, 3.0);
    const Vector3 base(50.0_nm, 50.0_nm, 40.0_nm);
    const PlannedApproach planned = planApproach(scene, {.position = base.head<2>()});
    ApproachDevice approach({{0.0, base}, {0.1, planned.start}}, planned.plan, kGain, device);
    EXPECT_EQ(approach.advance(1e-3).position, device);
    Vector3 last = device;
    for (int i = 0; i < 100; ++i) {
        last = approach.advance(1e-3).position;
    }
    EXPECT_NEAR(last.z() - device.z(), (planned.start.z() - base.z()) / kGain, 1e-15);
    EXPECT_EQ(approach.phase(), ApproachPhase::Baseline);
}

TEST(ApproachDevice, TheRecordedInputReplaysToTheSameBits) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const std::vector<TickSample> first = approached(scene);
    const std::vector<TickSample> second = approached(scene);
    ASSERT_EQ(first.size(), second.size());
    TickMemory memory;
    for (std::size_t i = 0; i < first.size(); ++i) {
        ASSERT_EQ(first[i].input.device.position, second[i].input.device.position) << i;
        const TickOutput replayed = tick(scene, first[i].input, memory);
        ASSERT_EQ(replayed.estimate.force, first[i].output.estimate.force) << i;
        ASSERT_EQ(replayed.base.position, first[i].output.base.position) << i;
    }
}

}  // namespace
}  // namespace asperity
