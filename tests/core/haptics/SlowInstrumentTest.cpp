#include "core/Units.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/SlowAfm.h"
#include "tests/support/TestScenes.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kPeriod = 20e-3;  // [s]

/// A scripted run with an instrument that answers every 20 ms, beside one that answers at once.
class SlowInstrument : public ::testing::Test {
protected:
    SceneDescription description = test::plainScene();
    Scene scene = buildScene(description, test::hillyMap());
    SimulatedAfm now{scene.trueSurface(), truthOf(scene)};  ///< what is true in this tick
    test::SlowAfm slow{scene.trueSurface(), truthOf(scene), kPeriod};
    DevicePath path = slidePath(scene, {.duration = 10.0, .slideLength = 60.0_nm});
};

TEST_F(SlowInstrument, LosesWeightAndTheEstimateStaysTrue) {
    double square = 0.0;
    long touching = 0;
    long flagged = 0;
    runVirtually(scene, path, slow, 10001, [&](const TickSample& sample) {
        (void)now.exchange(sample.output.base);
        const TickOutput& out = sample.output;
        const TipState& truth = now.trueState();
        // Snap-in and pull-off come when they come; what was measured before knows nothing of them.
        if (truth.contact.branch != ContactBranch::Bonded ||
            out.model.contact.branch != ContactBranch::Bonded) {
            return;
        }
        const Vector3 error = out.estimate.force - truth.force;
        square += error.dot(out.estimate.covariance.ldlt().solve(error)) / 3.0;
        flagged += out.flags.has(Validity::StaleSignals) ? 1 : 0;
        ++touching;
    });
    ASSERT_GT(touching, 3000);
    EXPECT_LT(square / static_cast<double>(touching), 1.5) << "chi-square per degree of freedom";
    EXPECT_GT(flagged, touching / 10);
    EXPECT_LT(flagged, touching) << "where nothing changes, an old answer is as good";
}

TEST_F(SlowInstrument, AnInstrumentOfNowIsNeverStale) {
    runVirtually(scene, path, now, 10001, [&](const TickSample& sample) {
        ASSERT_FALSE(sample.output.flags.has(Validity::StaleSignals));
    });
}

TEST_F(SlowInstrument, IsAFaultOnceItIsLost) {
    TickMemory memory;
    TickInput input;
    input.settings = scene.settings;
    input.timeStep = scene.timeStep();
    input.device.position = Vector3(64.0_nm, 64.0_nm, -1.0_nm) / scene.settings.positionGain;
    const auto step = [&] {
        const BaseCommand command = commandBase(scene, input, memory);
        input.measurement = slow.exchange(command.base);
        return tick(scene, input, command, memory);
    };
    EXPECT_EQ(step().fault, Fault::None);
    EXPECT_NE(step().deviceForce, Vector3::Zero());
    slow.lost = true;
    const TickOutput lost = step();
    EXPECT_EQ(lost.fault, Fault::InstrumentLost);
    EXPECT_EQ(lost.deviceForce, Vector3::Zero());
    EXPECT_TRUE(lost.base.position.allFinite());
    EXPECT_TRUE(memory.correction.allFinite());
    slow.lost = false;
    EXPECT_EQ(step().fault, Fault::InstrumentLost) << "latched";
    ++input.settings.rearms;
    EXPECT_EQ(step().fault, Fault::None);
}

}  // namespace
}  // namespace asperity
