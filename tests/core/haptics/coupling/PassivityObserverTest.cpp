#include "core/haptics/coupling/PassivityObserver.h"

#include "tests/core/haptics/TestDevice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::kTick;

constexpr double kStiffness = 300.0;  // [N/m]
constexpr double kPeriod = 0.1;       // of the device's motion [s]

/// The least energy seen while a device moves by 5 mm to and fro for a second against a spring and
/// damper whose force is `late` [s], watched as if it were `assumed` late.
double leastEnergy(double damping, double late, double assumed) {
    PassivityObserver observer(kStiffness, kTick, assumed);
    const double pulse = 2.0 * std::numbers::pi / kPeriod;
    double least = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double time = i * kTick;
        // What acts at the handle is told when it is sent.
        const double phase = pulse * (time + assumed - late);
        const double force =
            -5e-3 * (kStiffness * std::sin(phase) + damping * pulse * std::cos(phase));
        observer.observe({0.0, 0.0, 5e-3 * std::sin(pulse * time)}, {0.0, 0.0, force});
        least = std::min(least, observer.energy());
    }
    return least;
}

TEST(PassivityObserver, ADampedSpringTakesEnergy) {
    // The damper's force counts as stored, too: (B v)^2 / (2 K) at the first tick.
    const double speed = 5e-3 * 2.0 * std::numbers::pi / kPeriod;
    EXPECT_GT(leastEnergy(2.0, 0.0, 0.0), -std::pow(2.0 * speed, 2) / (2.0 * kStiffness));
}

TEST(PassivityObserver, ASpringGivesEnergyWhenItsForceIsLate) {
    // K X^2 pi sin(w tau) in each tenth of a second: 7.3 mJ, of which 0.5 s are kept.
    EXPECT_LT(leastEnergy(0.0, 5e-3, 5e-3), -10e-3);
}

TEST(PassivityObserver, TheDampingThatMakesUpForTheDelayIsStiffnessTimesDelay) {
    EXPECT_GT(leastEnergy(1.3 * kStiffness * 5e-3, 5e-3, 5e-3), -4e-3);
    EXPECT_LT(leastEnergy(0.3 * kStiffness * 5e-3, 5e-3, 5e-3), -10e-3);
}

TEST(PassivityObserver, ReleasingAStoredForceIsNoFault) {
    PassivityObserver observer(kStiffness, kTick, 0.0);
    for (int i = 0; i < 12000; ++i) {
        // Pressed to 10 mm within 0.1 s, held for 12 s, released within 0.1 s: 15 mJ.
        const double depth = 10e-3 * std::min(1.0, 0.01 * std::min(i, 12000 - i));
        observer.observe({0.0, 0.0, -depth}, {0.0, 0.0, kStiffness * depth});
        ASSERT_FALSE(observer.active()) << i;
    }
}

TEST(PassivityObserver, WhatWasTakenLongAgoCoversNothing) {
    PassivityObserver observer(kStiffness, kTick, 0.0);
    for (int i = 0; i < 1000; ++i) {
        observer.observe({i * 1e-3, 0.0, 0.0}, {-1.0, 0.0, 0.0});
    }
    EXPECT_GT(observer.energy(), 0.1);
    for (int i = 0; i < 5000; ++i) {
        observer.observe({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0});
    }
    EXPECT_LT(observer.energy(), 1e-4);
    for (int i = 0; i < 30; ++i) {
        observer.observe({1.0 - i * 1e-3, 0.0, 0.0}, {-1.0, 0.0, 0.0});
    }
    EXPECT_TRUE(observer.active());
}

}  // namespace
}  // namespace asperity
