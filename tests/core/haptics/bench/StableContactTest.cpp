#include "core/Error.h"
#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/bench/HeldTip.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>

namespace asperity {
namespace {

using test::designed;
using test::Hold;
using test::holdTip;

constexpr double kStill = 0.05e-3;  // [m] peak to peak: less, and no hand feels it move
constexpr double kShakes = 1e-3;    // [m]
constexpr CouplingGains kStiff{.stiffness = 600.0, .damping = 1.5, .proxyDamping = 3.0};
constexpr CouplingGains kSoft{.stiffness = 300.0, .damping = 1.0, .proxyDamping = 2.0};
constexpr ArmImpedance kStiffLightGrip{.stiffness = 150.0, .damping = 0.5};

BenchSetup benchOf(const ArmImpedance& arm, double delay) { return {.arm = arm, .delay = delay}; }

/// The largest motion over goals from just above the surface to hard pressed.
double worst(const Scene& scene, Hold hold) {
    double largest = 0.0;
    for (const double goal : {0.5e-3, -3e-3, -8e-3}) {
        hold.goal = goal;
        largest = std::max(largest, holdTip(scene, hold).peakToPeak);
    }
    return largest;
}

/// The device on an adhesive sample: without the coupling it shakes, with any of `gains` it is
/// still.
void expectCouplingHolds(const Scene& scene, const BenchSetup& bench,
                         std::initializer_list<CouplingGains> gains) {
    const double direct = worst(scene, {.bench = bench});
    EXPECT_GT(direct, kShakes);
    std::cout << "direct " << direct * 1e3 << " mm";
    for (const CouplingGains& coupling : gains) {
        const double coupled = worst(scene, {.bench = bench, .coupling = coupling});
        EXPECT_LT(coupled, kStill) << coupling.stiffness;
        std::cout << ", with " << coupling.stiffness << " N/m " << coupled * 1e3 << " mm";
    }
    std::cout << '\n';
}

TEST(StableContact, LightGripOnSiliconOxide) {
    const Scene scene = test::hapticScene("silicon_oxide", test::flatMap());
    expectCouplingHolds(scene, benchOf(kLightGrip, 1.0_ms),
                        {kStiff, kSoft, designed(scene, 1.0_ms)});
}

TEST(StableContact, LightGripOnPolystyreneWithThreeTimesTheForce) {
    const Scene scene = test::hapticScene("polystyrene", test::flatMap(), 1000.0, 3.0);
    expectCouplingHolds(scene, benchOf(kLightGrip, 1.0_ms),
                        {kStiff, kSoft, designed(scene, 1.0_ms)});
}

TEST(StableContact, NormalGripWithFiveMillisecondsDelay) {
    const Scene scene = test::hapticScene("silicon_oxide", test::flatMap());
    expectCouplingHolds(scene, benchOf(kNormalGrip, 5.0_ms),
                        {kStiff, kSoft, designed(scene, 5.0_ms)});
}

TEST(StableContact, LightGripWithFiveMillisecondsDelayNeedsTheSofterCoupling) {
    for (const char* material : {"silicon_oxide", "polystyrene"}) {
        const Scene scene = test::hapticScene(material, test::flatMap());
        const BenchSetup late = benchOf(kLightGrip, 5.0_ms);
        expectCouplingHolds(scene, late, {kSoft, designed(scene, 5.0_ms)});
        EXPECT_GT(worst(scene, {.bench = late, .coupling = kStiff}), kShakes) << material;
        const BenchSetup soon = benchOf(kLightGrip, 3.0_ms);
        EXPECT_LT(worst(scene, {.bench = soon, .coupling = kStiff}), kStill) << material;
    }
}

TEST(StableContact, GainsForAShortDelayDoNotHoldALongOne) {
    const Scene scene = test::hapticScene("silicon_oxide", test::flatMap());
    const BenchSetup late = benchOf(kLightGrip, 8.0_ms);
    EXPECT_GT(worst(scene, {.bench = late, .coupling = designed(scene, 1.0_ms)}), kShakes);
}

TEST(StableContact, RubberNeverShakes) {
    const Scene scene = test::hapticScene("silicone_rubber", test::flatMap());
    for (const double delay : {1.0_ms, 5.0_ms}) {
        const BenchSetup bench = benchOf(kLightGrip, delay);
        EXPECT_LT(worst(scene, {.bench = bench}), kStill);
        EXPECT_LT(worst(scene, {.bench = bench, .coupling = designed(scene, delay)}), kStill);
    }
}

/// Every grip, and a hand that lets go, at one rate and delay.
void expectDesignHolds(const Scene& scene, double delay) {
    const CouplingGains gains = designed(scene, delay);
    EXPECT_GE(gains.stiffness, kMinCouplingStiffness);
    EXPECT_LE(gains.proxyDamping, 5.0);
    double largest = 0.0;
    for (const ArmImpedance& arm : {kLightGrip, kStiffLightGrip, kNormalGrip}) {
        largest =
            std::max(largest, worst(scene, {.bench = benchOf(arm, delay), .coupling = gains}));
    }
    largest = std::max(
        largest,
        worst(scene, {.bench = benchOf(kLightGrip, delay), .coupling = gains, .letGo = true}));
    EXPECT_LT(largest, kStill) << delay;
    std::cout << scene.description.tickRate << " Hz, " << delay * 1e3 << " ms: stiffness "
              << gains.stiffness << " N/m, damping " << gains.damping << ", drag "
              << gains.proxyDamping << " N s/m, moves " << largest * 1e3 << " mm\n";
}

TEST(StableContact, DesignedGainsHoldAtEveryRateDelayAndGrip) {
    for (const double rate : {500.0, 1000.0, 4000.0}) {
        const Scene oxide = test::hapticScene("silicon_oxide", test::flatMap(), rate);
        const Scene plastic = test::hapticScene("polystyrene", test::flatMap(), rate, 3.0);
        for (const double delay : {0.0, 2.0_ms, 5.0_ms}) {
            SCOPED_TRACE(rate);
            expectDesignHolds(oxide, delay);
            expectDesignHolds(plastic, delay);
        }
        EXPECT_THROW((void)designed(oxide, 8.0_ms), Error);
    }
}

}  // namespace
}  // namespace asperity
