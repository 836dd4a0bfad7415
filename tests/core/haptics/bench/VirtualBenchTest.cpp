#include "core/haptics/bench/VirtualBench.h"

#include "core/Units.h"
#include "tests/core/haptics/TestDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::kTick;

constexpr HandlePhysics kIdeal{
    .mass = 0.1, .coulombFriction = 0.0, .viscousFriction = 0.0, .resolution = 0.0};

BenchSetup freeHandle(const HandlePhysics& handle, double delay = 0.0) {
    return {.handle = handle, .arm = kNoGrip, .delay = delay};
}

TEST(VirtualBench, AForceAcceleratesTheMass) {
    VirtualBench bench(freeHandle(kIdeal), Vector3::Zero());
    bench.setForce({0.0, 0.2, -0.1});
    for (int i = 0; i < 1000; ++i) {
        bench.advance(kTick);
    }
    EXPECT_LT((bench.velocity() - Vector3(0.0, 2.0, -1.0)).norm(), 1e-9);
    EXPECT_LT((bench.position() - Vector3(0.0, 1.0, -0.5)).norm(), 1e-4);
}

TEST(VirtualBench, JointsStickUntilMoreThanFrictionPulls) {
    HandlePhysics rough = kIdeal;
    rough.coulombFriction = 0.04;
    VirtualBench bench(freeHandle(rough), Vector3::Zero());
    bench.setForce({0.039, 0.0, 0.09});
    for (int i = 0; i < 1000; ++i) {
        bench.advance(kTick);
    }
    EXPECT_EQ(bench.velocity().x(), 0.0);
    EXPECT_NEAR(bench.velocity().z(), 0.5, 1e-9);  // (0.09 - 0.04) N / 0.1 kg for a second
}

TEST(VirtualBench, ViscousFrictionEndsAtForceOverFriction) {
    HandlePhysics viscous = kIdeal;
    viscous.viscousFriction = 2.0;
    VirtualBench bench(freeHandle(viscous), Vector3::Zero());
    bench.setForce({1.0, 0.0, 0.0});
    for (int i = 0; i < 2000; ++i) {
        bench.advance(kTick);
    }
    EXPECT_NEAR(bench.velocity().x(), 0.5, 1e-9);
}

TEST(VirtualBench, TheArmOscillatesAtItsNaturalFrequency) {
    BenchSetup setup = freeHandle(kIdeal);
    setup.arm = {.stiffness = 90.0, .damping = 0.0};
    VirtualBench bench(setup, Vector3::Zero());
    bench.reachFor({1e-3, 0.0, 0.0});
    const double quarter = 0.5 * std::numbers::pi / std::sqrt(90.0 / 0.1);
    for (int i = 0; i < std::lround(quarter / 0.1_ms); ++i) {
        bench.advance(0.1_ms);
    }
    EXPECT_NEAR(bench.position().x(), 1e-3, 5e-6);  // passes its goal
    EXPECT_NEAR(bench.velocity().x(), 1e-3 * std::sqrt(90.0 / 0.1), 1e-4);
}

TEST(VirtualBench, AForceActsTheDelayLate) {
    VirtualBench bench(freeHandle(kIdeal, 5.0_ms), Vector3::Zero());
    bench.advance(kTick);
    bench.setForce({1.0, 0.0, 0.0});
    for (int i = 0; i < 5; ++i) {
        bench.advance(kTick);
    }
    EXPECT_EQ(bench.velocity().x(), 0.0);
    bench.advance(kTick);
    EXPECT_NEAR(bench.velocity().x(), 0.01, 1e-12);
}

TEST(VirtualBench, EncodersTellWholeSteps) {
    HandlePhysics coarse = kIdeal;
    coarse.resolution = 30.0_um;
    VirtualBench bench(freeHandle(coarse), {100.0_um, -44.0_um, 0.0});
    const Vector3 sensed = bench.advance(kTick).position;
    EXPECT_LT((sensed - Vector3(90.0_um, -30.0_um, 0.0)).norm(), 1e-15);
    EXPECT_EQ(bench.position().x(), 100.0_um);
}

TEST(VirtualBench, MotorsGiveNoMoreThanTheyCan) {
    HandlePhysics weak = kIdeal;
    weak.maxForce = 2.0;
    VirtualBench bench(freeHandle(weak), Vector3::Zero());
    bench.setForce({100.0, -1.0, 0.0});
    bench.advance(kTick);
    EXPECT_NEAR(bench.velocity().x(), 0.02, 1e-12);
    EXPECT_NEAR(bench.velocity().y(), -0.01, 1e-12);
}

}  // namespace
}  // namespace asperity
