#include "core/Units.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/bench/HeldTip.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <iostream>

namespace asperity {
namespace {

using test::designed;

constexpr double kStillGuided = 0.01e-3;  // [m]
constexpr double kChatters = 0.02e-3;     // of the proxy, what the handle's mass leaves of it [m]

/// As a scene has it by itself, with the target pressed into the sample by one nanometer.
VirtualFixture guideTo(FixtureKind kind) {
    VirtualFixture guide = defaultScene().settings.guide;
    guide.kind = kind;
    guide.point = {64.0_nm, 64.0_nm, -1.0_nm};
    return guide;
}

TEST(GuidedContact, EveryGuideHoldsALightGripStill) {
    for (const char* material : {"silicon_oxide", "polystyrene", "silicone_rubber"}) {
        const Scene scene = test::hapticScene(material, test::flatMap());
        for (const double delay : {1.0_ms, 5.0_ms}) {
            for (const FixtureKind kind :
                 {FixtureKind::Plane, FixtureKind::Line, FixtureKind::Point}) {
                const test::HeldTip held =
                    test::holdTip(scene, {.bench = {.arm = kLightGrip, .delay = delay},
                                          .coupling = designed(scene, delay),
                                          .guide = guideTo(kind)});
                EXPECT_LT(held.peakToPeak, kStillGuided) << material << ' ' << delay;
            }
        }
    }
}

TEST(GuidedContact, AGuideBringsTheDeviceToItsTarget) {
    const Scene scene = test::hapticScene("silicone_rubber", test::flatMap());
    test::Hold hold{
        .bench = {.arm = kLightGrip}, .coupling = designed(scene, 1.0_ms), .goal = 6e-3};
    const double before = test::holdTip(scene, hold).handle.z();
    hold.guide = guideTo(FixtureKind::Plane);
    const double after = test::holdTip(scene, hold).handle.z();
    std::cout << "hand at " << before * 1e3 << " mm, guided " << after * 1e3 << " mm\n";
    EXPECT_LT(after, before - 3e-3);
}

TEST(GuidedContact, AGuideWithMoreDampingThanTheProxyShakes) {
    const Scene scene = test::hapticScene("silicone_rubber", test::flatMap());
    test::Hold hold{.bench = {.arm = kLightGrip},
                    .coupling = designed(scene, 1.0_ms),
                    .guide = guideTo(FixtureKind::Plane)};
    hold.guide.damping = 20.0;
    hold.guide.forceLimit = 10.0;
    EXPECT_GT(test::holdTip(scene, hold).peakToPeak, kChatters);
}

}  // namespace
}  // namespace asperity
