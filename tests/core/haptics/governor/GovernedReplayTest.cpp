#include "core/io/recording/TickLog.h"
#include "tests/core/haptics/governor/GuardedBench.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <set>

namespace asperity {
namespace {

/// A device that hesitates now and then and at last falls silent; with a dead-man switch.
void hesitate(DeviceState& device, double time) {
    const double rest = time - 0.4 * std::floor(time / 0.4);
    device.buttons = time > 0.1 && (time < 2.0 || time > 2.1) ? 1U : 0U;
    device.age = time > 2.7 ? time - 2.7 : std::max(0.0, 0.02 - rest);
}

TEST(GovernedReplay, ARecordedRunReplaysToTheSameBitsFromItsMiddle) {
    test::GuardedBench bench;
    bench.input.settings.governor = {
        .maxForce = 0.3, .engageTime = 0.5, .maxDeviceSpeed = 1.2, .deadManButton = 0};
    bench.input.starts = 3;
    bench.tamper = hesitate;
    bench.run(0.3);
    const test::ScratchFolder folder;
    writeTickMemory(folder.path() / "memory.csv", bench.memory);
    std::vector<TickSample> lived = bench.run(1.0);
    bench.reachFor(-5e-3);
    for (const TickSample& sample : bench.run(2.0)) {
        lived.push_back(sample);
    }
    TickInputWriter writer(folder.path() / "input.csv");
    std::set<ForceState> states;
    for (const TickSample& sample : lived) {
        writer.take(sample);
        states.insert(sample.output.forceState);
    }
    writer.close();
    EXPECT_EQ(states.size(), 7U) << "the run must pass through all states but Off";

    TickMemory memory = readTickMemory(folder.path() / "memory.csv");
    const std::vector<TickSample> read = readTickInputs(folder.path() / "input.csv");
    ASSERT_EQ(read.size(), lived.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const TickOutput again = tick(bench.scene(), read[i].input, memory);
        ASSERT_EQ(again.deviceForce, lived[i].output.deviceForce) << i;
        ASSERT_EQ(again.forceState, lived[i].output.forceState) << i;
        ASSERT_EQ(again.fault, lived[i].output.fault) << i;
    }
}

}  // namespace
}  // namespace asperity
