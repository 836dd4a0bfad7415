#include "core/haptics/coupling/CouplingDesign.h"

#include "core/Error.h"
#include "core/Units.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace asperity {
namespace {

constexpr DeviceSpecification kPhantom{
    .maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075};

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
        EXPECT_GE(gains.stiffness, kSoftestCoupling) << delay;
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

}  // namespace
}  // namespace asperity
