#include "core/haptics/HapticTick.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/VirtualRun.h"
#include "core/probe/recorded/RecordedAfm.h"
#include "core/scene/Scene.h"
#include "tests/core/probe/recorded/AdhesiveCycle.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// A tick on an instrument that plays an adhesive cycle above the middle of a flat scan.
class RecordedInstrument : public ::testing::Test {
protected:
    TickOutput stepTo(double x, double z) {
        input.device.position = Vector3(x, 64e-9, z) / scene.settings.positionGain;
        const BaseCommand command = commandBase(scene, input, memory);
        input.measurement = afm.exchange(command.base);
        return tick(scene, input, command, memory);
    }

    Scene scene = buildScene(test::plainScene(), test::flatMap());
    std::shared_ptr<const PlayedCurve> curve = playedCurve(test::adhesiveCycle(), 0.0);
    RecordedAfm afm{curve, scene.trueSurface(), scene.description.tip.radius,
                    scene.belief.cantilever};
    TickMemory memory;
    TickInput input{.settings = scene.settings, .timeStep = scene.timeStep()};
};

TEST_F(RecordedInstrument, TellsWhatIsNotInTheRecord) {
    EXPECT_FALSE(stepTo(64e-9, 50e-9).flags.has(Validity::Extrapolated));
    EXPECT_FALSE(stepTo(64e-9, -5e-9).flags.has(Validity::Extrapolated));
    EXPECT_TRUE(stepTo(64e-9, -4e-9).flags.has(Validity::Extrapolated));
    EXPECT_FALSE(stepTo(64e-9, -6e-9).flags.has(Validity::Extrapolated));
    EXPECT_FALSE(stepTo(64e-9, -6e-9).flags.has(Validity::AsideOfRecord));
    EXPECT_TRUE(stepTo(60e-9, -6e-9).flags.has(Validity::AsideOfRecord));
}

TEST_F(RecordedInstrument, IsAFaultBelowTheRecord) {
    EXPECT_EQ(stepTo(64e-9, -5e-9).fault, Fault::None);
    const TickOutput ended = stepTo(64e-9, -2.0 * test::kCycleDeepest);
    EXPECT_EQ(ended.fault, Fault::RecordEnded);
    EXPECT_EQ(ended.deviceForce, Vector3::Zero());
    EXPECT_TRUE(memory.correction.allFinite());
    EXPECT_EQ(stepTo(64e-9, 0.0).fault, Fault::RecordEnded) << "latched";
    ++input.settings.rearms;
    EXPECT_EQ(stepTo(64e-9, 0.0).fault, Fault::None);
}

TEST_F(RecordedInstrument, EndsAnApproachThatItCannotServe) {
    PlannedApproach approach = planApproach(scene, {.duration = 2.0});
    approach.plan.setpoint = 1e-6;
    approach.plan.maxDescent = 1e-6;
    ApproachDevice device(approach, scene.settings.positionGain);
    double lowest = 0.0;
    runVirtually(scene, device, afm, 20001, [&lowest](const TickSample& sample) {
        lowest = std::min(lowest, sample.output.base.position.z());
    });
    EXPECT_TRUE(device.isBlocked());
    EXPECT_LT(lowest, -test::kCycleDeepest);
    EXPECT_GT(lowest, -test::kCycleDeepest - 0.06 * approach.plan.speed);
}

}  // namespace
}  // namespace asperity
