#include "tests/core/haptics/governor/GuardedBench.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace asperity {
namespace {

constexpr double kSoon = 5e-3;     // [s]
constexpr double kPressing = 0.1;  // force of a device that presses, at least [N]
constexpr double kEngaged = 1.2;   // after so long the force acts fully [s]

using Samples = std::vector<TickSample>;
using test::GuardedBench;
using test::kNan;

bool isOff(const TickSample& sample) { return sample.output.deviceForce == Vector3::Zero(); }

/// Time from the event to the tick from which on there is no force.
double timeUntilOff(const Samples& samples, double event) {
    const auto last = std::find_if_not(samples.rbegin(), samples.rend(), isOff);
    return last == samples.rend() ? 0.0 : last.base()->time - event;
}

void expectFault(const Samples& samples, Fault fault) {
    ASSERT_FALSE(samples.empty());
    EXPECT_EQ(samples.back().output.fault, fault);
    EXPECT_EQ(samples.back().output.forceState, ForceState::Fault);
    EXPECT_TRUE(isOff(samples.back()));
}

/// The cause is gone, the fault stays; taken back, the force comes on by and by.
void expectLatchedUntilTakenBack(GuardedBench& bench, Fault fault) {
    bench.tamper = nullptr;
    bench.reachFor(4e-3);
    expectFault(bench.run(1.0), fault);
    ++bench.input.settings.rearms;
    const Samples after = bench.run(kEngaged);
    EXPECT_EQ(after.front().output.fault, Fault::None);
    EXPECT_EQ(after.front().output.forceState, ForceState::Engaging);
    EXPECT_EQ(after.back().output.forceState, ForceState::On);
    bench.reachFor(
        -8e-3);  // a position that was not finite, and the return from it, count for nothing
    EXPECT_GT(bench.run(0.8).back().output.deviceForce.norm(), kPressing);
}

TEST(FaultInjection, WithoutAFaultTheTipIsHeldWithAForce) {
    GuardedBench bench;
    EXPECT_GT(bench.pressDown(), kPressing);
    for (const TickSample& sample : bench.run(1.0)) {
        ASSERT_EQ(sample.output.forceState, ForceState::On);
        ASSERT_EQ(sample.output.fault, Fault::None);
    }
}

TEST(FaultInjection, ANonFinitePositionTakesTheForceAtOnce) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    const double event = bench.now();
    bench.tamper = [](DeviceState& device, double) { device.position.x() = kNan; };
    const Samples samples = bench.run(0.1);
    EXPECT_LE(timeUntilOff(samples, event), kSoon);
    expectFault(samples, Fault::NotFinite);
    expectLatchedUntilTakenBack(bench, Fault::NotFinite);
}

TEST(FaultInjection, AnUnpluggedDeviceGetsNoForceAtOnce) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    const double event = bench.now();
    bench.tamper = [](DeviceState& device, double) { device.connected = false; };
    const Samples samples = bench.run(0.1);
    EXPECT_LE(timeUntilOff(samples, event), kSoon);
    expectFault(samples, Fault::DeviceLost);
    expectLatchedUntilTakenBack(bench, Fault::DeviceLost);
}

TEST(FaultInjection, ARunawayTripsWithinFiveMilliseconds) {
    for (const double phase : {0.0, 1e-3}) {  // of the stretches over which speed is measured
        GuardedBench bench;
        ASSERT_GT(bench.pressDown(), kPressing);
        bench.run(phase);
        const double event = bench.now();
        bench.tamper = [event](DeviceState& device, double time) {
            device.position.z() += 1.6 * (time - event);  // the limit is 1.5 m/s
        };
        const Samples samples = bench.run(0.1);
        EXPECT_LE(timeUntilOff(samples, event), kSoon) << phase;
        expectFault(samples, Fault::VelocityTrip);
        expectLatchedUntilTakenBack(bench, Fault::VelocityTrip);
    }
}

TEST(FaultInjection, AFastDeviceThatIsNoRunawayDoesNotTrip) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    const double event = bench.now();
    bench.tamper = [event](DeviceState& device, double time) {
        device.position.z() += 1.3 * (time - event);
    };
    for (const TickSample& sample : bench.run(0.1)) {
        ASSERT_EQ(sample.output.fault, Fault::None);
    }
}

/// The device sends nothing any more from `event` on: the position stays its last, the age grows.
void fallSilent(GuardedBench& bench, double event) {
    const Vector3 last = bench.input.device.position;
    bench.tamper = [last, event](DeviceState& device, double time) {
        device.position = last;
        device.age = time - event;
    };
}

TEST(FaultInjection, SilenceFadesTheForceFromTenMillisecondsOnAndEndsItByFifty) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    const double event = bench.now();
    fallSilent(bench, event);
    const Samples samples = bench.run(0.1);
    for (const TickSample& sample : samples) {
        const double silence = sample.time - event;
        const ForceState state = sample.output.forceState;
        if (silence < 9.5e-3) {
            EXPECT_EQ(state, ForceState::On) << silence;
        } else if (silence > 10.5e-3 && silence < 39.5e-3) {
            EXPECT_EQ(state, ForceState::Fading) << silence;
            EXPECT_FALSE(isOff(sample)) << silence;
        } else if (silence > 40.5e-3) {
            EXPECT_TRUE(isOff(sample)) << silence;
        }
    }
    EXPECT_LE(timeUntilOff(samples, event), 50e-3);
    expectFault(samples, Fault::DeviceSilent);
    expectLatchedUntilTakenBack(bench, Fault::DeviceSilent);
}

TEST(FaultInjection, SilenceOfTwentyMillisecondsIsNoFault) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    fallSilent(bench, bench.now());
    EXPECT_EQ(bench.run(20e-3).back().output.forceState, ForceState::Fading);
    bench.tamper = nullptr;
    const Samples after = bench.run(0.5);
    EXPECT_EQ(after.front().output.forceState, ForceState::Engaging);
    EXPECT_EQ(after.back().output.forceState, ForceState::On);
}

TEST(FaultInjection, AReleasedDeadManSwitchTakesTheForceWithinATickAndNeedsNoRearm) {
    GuardedBench bench;
    bench.input.settings.governor.deadManButton = 2;
    EXPECT_EQ(bench.run(0.1).back().output.forceState, ForceState::Released);
    const auto hold = [](DeviceState& device, double) { device.buttons = 1U << 2U; };
    bench.tamper = hold;
    ASSERT_GT(bench.pressDown(), kPressing);
    const double event = bench.now();
    bench.tamper = [](DeviceState& device, double) { device.buttons = 3U; };
    const Samples released = bench.run(0.5);
    EXPECT_LE(timeUntilOff(released, event), kSoon);
    EXPECT_EQ(released.back().output.forceState, ForceState::Released);
    EXPECT_EQ(released.back().output.fault, Fault::None);
    bench.tamper = hold;
    const Samples pressed = bench.run(0.1);
    EXPECT_EQ(pressed.back().output.forceState, ForceState::Waiting) << "the tip is deep";
    EXPECT_TRUE(isOff(pressed.back()));
    bench.reachFor(4e-3);
    EXPECT_EQ(bench.run(0.5).back().output.forceState, ForceState::Engaging);
    EXPECT_EQ(bench.run(kEngaged).back().output.forceState, ForceState::On);
}

TEST(FaultInjection, EscTakesTheForceInTheNextTickAndItComesOnByAndBy) {
    GuardedBench bench;
    ASSERT_GT(bench.pressDown(), kPressing);
    bench.input.settings.forcesOn = false;
    const Samples off = bench.run(0.5);
    EXPECT_TRUE(isOff(off.front()));
    EXPECT_EQ(timeUntilOff(off, off.front().time), 0.0);
    EXPECT_EQ(off.back().output.forceState, ForceState::Off);
    bench.reachFor(4e-3);
    bench.run(0.5);
    bench.input.settings.forcesOn = true;
    const Samples on = bench.run(kEngaged);
    EXPECT_EQ(on.front().output.forceState, ForceState::Engaging);
    EXPECT_EQ(on.back().output.forceState, ForceState::On);
}

TEST(FaultInjection, EveryFaultHasANameOfItsOwn) {
    EXPECT_EQ(std::string(keyOf(Fault::DeviceSilent)), "device_silent");
    EXPECT_EQ(std::string(keyOf(Fault::VelocityTrip)), "velocity_trip");
}

}  // namespace
}  // namespace asperity
