#include "core/haptics/blackbox/BlackBox.h"
#include "core/io/recording/TickLog.h"
#include "tests/core/haptics/governor/GuardedBench.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace asperity {
namespace {

using test::GuardedBench;
constexpr double kFrame = 0.025;  // from one visit of the ring to the next [s]

/// Lets the bench run and feeds the box as a window does: all ticks of a frame, then the latest.
void live(GuardedBench& bench, BlackBox& box, double duration) {
    for (const double end = bench.now() + duration - 0.5 * kFrame; bench.now() < end;) {
        Snapshot latest;
        for (const TickSample& sample : bench.run(kFrame)) {
            box.take(sample);
            latest.sample = sample;
        }
        latest.memory = bench.memory;
        box.mark(latest);
    }
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

void expectSameBits(const Vector3& one, const Vector3& other) {
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(bits(one[i]), bits(other[i]));
    }
}

/// Writes the box, reads it back and runs its ticks again.
void expectReplays(const Scene& scene, const BlackBox& box) {
    const test::ScratchFolder folder;
    writeTickMemory(folder.path() / "memory.csv", box.memory());
    TickInputWriter writer(folder.path() / "input.csv");
    for (const TickSample& sample : box.samples()) {
        writer.take(sample);
    }
    writer.close();
    TickMemory memory = readTickMemory(folder.path() / "memory.csv");
    const std::vector<TickSample> read = readTickInputs(folder.path() / "input.csv");
    ASSERT_EQ(read.size(), box.samples().size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        SCOPED_TRACE(i);
        const TickOutput& lived = box.samples()[i].output;
        const TickOutput again = tick(scene, read[i].input, memory);
        ASSERT_EQ(again.fault, lived.fault);
        ASSERT_EQ(again.forceState, lived.forceState);
        expectSameBits(again.deviceForce, lived.deviceForce);
        expectSameBits(again.model.force, lived.model.force);
        expectSameBits(again.estimate.force, lived.estimate.force);
        expectSameBits(again.estimate.covariance.diagonal(), lived.estimate.covariance.diagonal());
        ASSERT_EQ(again.flags.bits(), lived.flags.bits());
    }
}

/// Presses, then something goes wrong: the last two seconds up to that tick replay.
void expectReplaysUpTo(Fault fault, void (*tamper)(DeviceState&, double)) {
    GuardedBench bench;
    BlackBox box(bench.scene().timeStep(), 2.0);
    live(bench, box, 1.2);
    bench.reachFor(-5e-3);
    live(bench, box, 1.5);
    ASSERT_FALSE(box.frozen());
    bench.tamper = tamper;
    live(bench, box, 0.3);
    ASSERT_TRUE(box.frozen());
    EXPECT_EQ(box.samples().back().output.fault, fault);
    EXPECT_GT(box.samples().front().time, 0.5) << "the replay must begin in the middle";
    EXPECT_GE(box.samples().size(), 2000U);
    EXPECT_GT(box.samples()[box.samples().size() - 2].output.deviceForce.norm(), 0.1);
    expectReplays(bench.scene(), box);
}

TEST(BlackBoxReplay, RepeatsALostDeviceToTheSameBits) {
    expectReplaysUpTo(Fault::DeviceLost,
                      [](DeviceState& device, double) { device.connected = false; });
}

TEST(BlackBoxReplay, RepeatsASilentDeviceToTheSameBits) {
    expectReplaysUpTo(Fault::DeviceSilent, [](DeviceState& device, double) { device.age = 0.05; });
}

TEST(BlackBoxReplay, RepeatsANonFinitePositionToTheSameBits) {
    expectReplaysUpTo(Fault::NotFinite, [](DeviceState& device, double) {
        device.position.x() = std::numeric_limits<double>::quiet_NaN();
    });
}

}  // namespace
}  // namespace asperity
