#include "core/Units.h"
#include "core/haptics/HapticLoop.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/ScriptedHand.h"
#include "core/haptics/VirtualRun.h"
#include "core/probe/SimulatedAfm.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <memory>

namespace asperity {
namespace {

TEST(TickAllocation, TickAndSimulatedInstrumentAllocateNothingInAnyState) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const HandPath path = approachPath(scene, {.duration = 2.0});
    SimulatedAfm afm(scene.surface, scene.truth);
    TickMemory memory;
    TickInput input;
    bool touched = false;
    bool released = false;
    for (int i = 0; i <= 2000; ++i) {
        input.hand.position = positionAt(path, i * 1e-3);
        const std::size_t before = test::allocationCount();
        input.measurement = afm.exchange(commandBase(scene, input, memory).base);
        const TickOutput output = tick(scene, input, memory);
        ASSERT_EQ(test::allocationCount(), before) << "tick " << i;
        touched = touched || output.region() == TipRegion::Contact;
        released = touched && output.region() == TipRegion::Far;
    }
    EXPECT_TRUE(touched && released) << "the run must pass through all states";
}

TEST(TickAllocation, TheRunningLoopAllocatesNothing) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    ScriptedHand hand(approachPath(scene, {.duration = 0.5}), scene.settings.positionGain);
    SimulatedAfm afm(scene.surface, scene.truth);
    HapticLoop loop(scene, hand, afm);
    loop.start();
    while (loop.snapshot().statistics.ticks == 0) {
    }
    const std::size_t before = test::allocationCount();
    bool touched = false;
    while (loop.snapshot().statistics.ticks < 1010) {
        touched = touched || loop.snapshot().sample.output.region() == TipRegion::Contact;
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(touched);
}

TEST(TickAllocation, CounterSeesOperatorNewAndEigen) {
    std::size_t before = test::allocationCount();
    const auto number = std::make_unique<int>(1);
    EXPECT_GT(test::allocationCount(), before);
    before = test::allocationCount();
    const Eigen::VectorXd vector = Eigen::VectorXd::Constant(*number + 99, 1.0);
    EXPECT_GT(test::allocationCount(), before) << vector.sum();
}

}  // namespace
}  // namespace asperity
