#include "core/haptics/EnergyWatch.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr double kTick = 1.0_ms;

/// A tick of a device at a height, told a force.
TickSample tickOf(double height, double force) {
    TickSample sample;
    sample.input.device.position.z() = height;
    sample.input.device.maxForce = 5.0;
    sample.input.settings.coupling = {.stiffness = 300.0, .damping = 2.0, .proxyDamping = 3.0};
    sample.input.timeStep = kTick;
    sample.input.starts = 1;
    sample.output.deviceForce.z() = force;
    return sample;
}

/// Pushes the device along by 1 N for 20 ms at 1 m/s: 20 mJ that nobody put in.
void push(EnergyWatch& watch, double from) {
    for (int i = 0; i < 20; ++i) {
        watch.take(tickOf(from + 1e-3 * i, 1.0));
    }
}

TEST(EnergyWatch, SeesADeviceThatIsGivenEnergy) {
    EnergyWatch watch(kTick, 0.0);
    EXPECT_FALSE(watch.active());
    push(watch, 0.0);
    ASSERT_NE(watch.observer(), nullptr);
    EXPECT_TRUE(watch.active());
    // The work, less 2 % that leaks, and what the spring holds in the end.
    const double given = 0.98 * 19e-3 + 1.0 / (2.0 * 300.0);
    EXPECT_NEAR(watch.observer()->energy(), -given, 0.01 * given);
    EXPECT_NEAR(watch.observer()->spring(), 1.0 / (2.0 * 300.0), 1e-12);
}

TEST(EnergyWatch, ADelayMovesTheForceToTheMotionThatItMeets) {
    // Pulled back with a force that grows with the speed, 5 ms late: given energy as of 50 Hz on.
    const auto least = [](double delay) {
        EnergyWatch watch(kTick, delay);
        double energy = 0.0;
        for (int i = 0; i < 500; ++i) {
            const double phase = 2.0 * std::numbers::pi * 70.0 * i * kTick;
            watch.take(tickOf(1e-3 * std::sin(phase), -1.0 * std::cos(phase)));
            energy = std::min(energy, watch.observer()->energy());
        }
        return energy;
    };
    EXPECT_GT(least(0.0), -10e-3);
    EXPECT_LT(least(6.0_ms), -10e-3);
}

TEST(EnergyWatch, ADeviceWithoutMotorsOrCouplingIsNotWatched) {
    EnergyWatch watch(kTick, 0.0);
    push(watch, 0.0);
    TickSample mouse = tickOf(0.0, 1.0);
    mouse.input.device.maxForce = 0.0;
    watch.take(mouse);
    EXPECT_EQ(watch.observer(), nullptr);
    push(watch, 0.0);
    TickSample direct = tickOf(0.0, 1.0);
    direct.input.settings.coupling = {};
    watch.take(direct);
    EXPECT_EQ(watch.observer(), nullptr);
    EXPECT_FALSE(watch.active());
}

TEST(EnergyWatch, AStartOrAnotherCouplingBeginsAnew) {
    EnergyWatch watch(kTick, 0.0);
    push(watch, 0.0);
    TickSample again = tickOf(5.0, 1.0);  // moved while the loop rested
    again.input.starts = 2;
    watch.take(again);
    EXPECT_EQ(watch.observer()->energy(), 0.0);
    push(watch, 5.0);
    ASSERT_TRUE(watch.active());
    TickSample other = tickOf(5.0, 1.0);
    other.input.settings.coupling.stiffness = 200.0;
    watch.take(other);
    EXPECT_EQ(watch.observer()->energy(), 0.0);
}

}  // namespace
}  // namespace asperity
