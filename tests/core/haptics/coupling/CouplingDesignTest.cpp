#include "core/haptics/coupling/CouplingDesign.h"

#include "core/Error.h"
#include "core/Units.h"
#include "tests/core/haptics/TestDevice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asperity {
namespace {

using test::kPhantom;

std::string refusal(const DeviceSpecification& device, const LoopTiming& timing) {
    try {
        static_cast<void>(designCoupling(device, timing));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(CouplingDesign, IsAsStiffAsShownWhereTheForceIsFresh) {
    const CouplingGains gains = designCoupling(kPhantom, {.timeStep = 1.0_ms, .delay = 1.0_ms});
    EXPECT_EQ(gains.stiffness, 600.0);
    // Kc tau + 0.3 sqrt(Kc m) = 0.9 + 2.012
    EXPECT_NEAR(gains.damping, 2.9125, 1e-4);
    EXPECT_EQ(gains.proxyDamping, 3.0);
}

TEST(CouplingDesign, FollowsTheDelay) {
    CouplingGains last = designCoupling(kPhantom, {.timeStep = 1.0_ms, .delay = 3.0_ms});
    for (const double delay : {4.5_ms, 5.0_ms, 5.5_ms, 6.0_ms}) {
        const CouplingGains gains = designCoupling(kPhantom, {.timeStep = 1.0_ms, .delay = delay});
        EXPECT_LT(gains.stiffness, last.stiffness) << delay;
        EXPECT_GE(gains.stiffness, kMinCouplingStiffness) << delay;
        // What the delay takes away is more than covered.
        EXPECT_GT(gains.damping, gains.stiffness * (delay + 0.5_ms)) << delay;
        last = gains;
    }
}

TEST(CouplingDesign, NoStifferThanTheDeviceAndNoMoreDampedThanItRenders) {
    DeviceSpecification soft = kPhantom;
    soft.maxStiffness = 300.0;
    EXPECT_EQ(designCoupling(soft, {.delay = 1.0_ms}).stiffness, 300.0);
    DeviceSpecification poor = kPhantom;
    poor.maxDamping = 2.0;
    const CouplingGains gains = designCoupling(poor, {.delay = 1.0_ms});
    EXPECT_NEAR(gains.damping, 2.0, 1e-12);
    EXPECT_LT(gains.stiffness, 600.0);
}

TEST(CouplingDesign, TakesAMassThatIsNotKnownAsALightOne) {
    DeviceSpecification unknown = kPhantom;
    unknown.effectiveMass = 0.0;
    const LoopTiming late{.timeStep = 1.0_ms, .delay = 4.0_ms};
    EXPECT_LT(designCoupling(unknown, late).stiffness, designCoupling(kPhantom, late).stiffness);
}

TEST(CouplingDesign, RefusesADelayThatLeavesNothingStiffAndSaysWhatItLeaves) {
    // 0.075 kg / (6 * (8.5 ms)^2) = 173 N/m.
    const std::string told = refusal(kPhantom, {.timeStep = 1.0_ms, .delay = 8.0_ms});
    EXPECT_NE(told.find("173 N/m"), std::string::npos) << told;
    EXPECT_NE(told.find(" 8.5 ms"), std::string::npos) << told;
    EXPECT_NE(told.find("250 N/m"), std::string::npos) << told;
}

TEST(CouplingDesign, RefusesWhatIsNoDevice) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal({.maxStiffness = 0.0, .maxDamping = 8.0}, {}), "");
    EXPECT_NE(refusal({.maxStiffness = 800.0, .maxDamping = kNan}, {}), "");
    EXPECT_NE(refusal({.maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = -1.0}, {}), "");
    EXPECT_NE(refusal(kPhantom, {.timeStep = 0.0}), "");
    EXPECT_NE(refusal(kPhantom, {.delay = kNan}), "");
}

/// Whether a handle with nobody at it comes to rest, stepped by 10 us from 1 mm: m x'' = -Kc x - Bc
/// x' of tau ago.
bool comesToRest(const CouplingGains& gains, double mass, double age) {
    constexpr double kStep = 10e-6;
    const auto late = static_cast<std::size_t>(std::lround(age / kStep));
    std::vector<double> forces(late, 0.0);
    double position = 1e-3;
    double speed = 0.0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < 400000; ++i) {
        const double force =
            std::exchange(forces[i % late], -gains.stiffness * position - gains.damping * speed);
        speed += kStep * force / mass;
        position += kStep * speed;
        if (i > 300000) {
            farthest = std::max(farthest, std::abs(position));
        }
    }
    return farthest < 1e-3;
}

TEST(CouplingDesign, ACouplingHoldsExactlyWhereAHandleAloneComesToRest) {
    int holding = 0;
    for (const double stiffness : {100.0, 300.0, 600.0, 800.0}) {
        for (const double damping : {0.3, 1.0, 1.5, 3.0, 8.0}) {
            for (const double delay : {1.0_ms, 3.0_ms, 5.0_ms, 9.0_ms}) {
                const CouplingGains gains{stiffness, damping, 3.0};
                const bool holds = holdsHandle(gains, kPhantom, {.delay = delay});
                EXPECT_EQ(holds, comesToRest(gains, 0.075, delay + 0.5_ms))
                    << stiffness << " " << damping << " " << delay;
                holding += holds ? 1 : 0;
            }
        }
    }
    EXPECT_GT(holding, 10);
    EXPECT_LT(holding, 70);
}

TEST(CouplingDesign, WhatIsDesignedHolds) {
    for (const double delay : {0.0, 1.0_ms, 3.0_ms, 6.0_ms}) {
        const LoopTiming timing{.timeStep = 1.0_ms, .delay = delay};
        EXPECT_TRUE(holdsHandle(designCoupling(kPhantom, timing), kPhantom, timing)) << delay;
    }
}

TEST(CouplingDesign, ACouplingStifferOrMoreDampedThanTheDeviceDoesNotHold) {
    EXPECT_FALSE(holdsHandle({801.0, 3.0, 3.0}, kPhantom, {.delay = 0.0}));
    EXPECT_FALSE(holdsHandle({300.0, 8.1, 3.0}, kPhantom, {.delay = 0.0}));
    EXPECT_TRUE(holdsHandle({800.0, 3.0, 3.0}, kPhantom, {.delay = 0.0}));
}

}  // namespace
}  // namespace asperity
