#include "tests/core/haptics/GuidedDevice.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

using test::GuidedDevice;
using test::kGains;

constexpr double kPullAt40nm = 1e-4;               // of what the sample pulls from there [N]
const Vector3 kDeviceAt40nm(64e-3, 64e-3, 40e-3);  // of the device [m]
const Vector3 kTarget(64e-9, 64e-9, 40e-9);        // where that sends the base [m]

VirtualFixture guideTo(FixtureKind kind, const Vector3& point) {
    return {.kind = kind,
            .point = point,
            .stiffness = 200.0,
            .damping = 0.5,
            .forceLimit = 1.0,
            .captureDistance = 50e-9};
}

TEST(GuidedTick, AGuidePullsTheBaseToItsTargetAndTheDeviceFeelsIt) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice device(scene);
    device.settings.guide = guideTo(FixtureKind::Point, kTarget);
    device.moveTo(kDeviceAt40nm, 1000);
    const Vector3 aside(1e-3, 0.0, 2e-3);
    const TickOutput out = device.moveTo(kDeviceAt40nm + aside, 4000);
    // Coupling and guide in series: the base comes to Kc / (Kc + k) of the way. The guide gives
    // less than k e by its fading towards the capture distance and towards its limit.
    const Vector3 way = (out.base.position - kTarget) / 1e-6;
    EXPECT_LT(way.norm(), 0.72 * aside.norm());
    EXPECT_GT(way.norm(), 0.66 * aside.norm());
    EXPECT_LT((out.deviceForce + kGains.stiffness * (aside - way)).norm(), 1e-6);
    EXPECT_LT(out.deviceForce.normalized().dot(aside.normalized()), -1.0 + 1e-9);
}

TEST(GuidedTick, APlaneLeavesTheDeviceFreeWithinIt) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice device(scene);
    device.settings.guide = guideTo(FixtureKind::Plane, kTarget);
    device.moveTo(kDeviceAt40nm, 1000);
    const TickOutput within = device.moveTo(kDeviceAt40nm + Vector3(15e-3, -10e-3, 0.0), 4000);
    EXPECT_LT(within.deviceForce.norm(), kPullAt40nm);
    EXPECT_LT(device.moveTo(kDeviceAt40nm + Vector3(15e-3, -10e-3, 3e-3), 4000).deviceForce.z(),
              -0.3);
}

TEST(GuidedTick, AGuideThatIsSwitchedOnComesOnByAndBy) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice device(scene);
    const Vector3 position = kDeviceAt40nm + Vector3(5e-3, 0.0, 0.0);
    Vector3 last = device.moveTo(position, 100).deviceForce;
    device.settings.guide = guideTo(FixtureKind::Point, kTarget);
    double steepest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const Vector3 now = device.moveTo(position).deviceForce;
        steepest = std::max(steepest, (now - last).norm());
        last = now;
    }
    EXPECT_GT(last.norm(), 0.4);
    EXPECT_LT(steepest, 2.5e-3) << "1 N in half a second is 2 mN a tick";
}

TEST(GuidedTick, NeitherZoomNorAnotherGuideMovesTheBaseByItself) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice device(scene);
    device.settings.guide = guideTo(FixtureKind::Point, kTarget);
    device.moveTo(kDeviceAt40nm, 1000);
    const Vector3 position = kDeviceAt40nm + Vector3(3e-3, 0.0, 0.0);
    const TickOutput before = device.moveTo(position, 4000);
    ASSERT_GT(before.deviceForce.norm(), 0.2);
    device.settings.positionGain = 2e-6;
    const TickOutput zoomed = device.moveTo(position);
    EXPECT_LT((zoomed.base.position - before.base.position).norm(), 1e-15);
    EXPECT_LT(zoomed.deviceForce.norm(), kPullAt40nm) << "the guide comes on again";
    const TickOutput held = device.moveTo(position, 4000);
    device.settings.guide = {};
    const TickOutput without = device.moveTo(position);
    EXPECT_LT((without.base.position - held.base.position).norm(), 1e-15);
    EXPECT_LT(without.deviceForce.norm(), kPullAt40nm);
}

TEST(GuidedTick, WithTheTipUnderControlItIsTheTipThatIsGuided) {
    Scene scene = buildScene(test::plainScene(), test::flatMap());  // soft enough to be held
    scene.settings.positionGain = 1e-6;
    scene.settings.forceGain = 1e8;
    scene.settings.coupling = kGains;
    GuidedDevice device(scene);
    const Vector3 pressed(64e-3, 64e-3, -2e-3);
    device.settings.positionControl = PositionControl::Tip;
    device.moveTo({64e-3, 64e-3, 5e-3});
    const TickOutput before = device.glideTo(pressed, 6000);
    ASSERT_EQ(before.region(), TipRegion::Contact);
    ASSERT_LT(before.base.position.z(), before.model.tip.z() - 0.1e-9) << "the base is ahead";
    device.settings.guide = guideTo(FixtureKind::Plane, before.model.tip);
    const TickOutput atTip = device.moveTo(pressed, 4000);
    EXPECT_LT((atTip.deviceForce - before.deviceForce).norm(), 0.01 * before.deviceForce.norm());
    device.settings.guide = guideTo(FixtureKind::Plane, before.base.position);
    const TickOutput atBase = device.moveTo(pressed, 4000);
    EXPECT_LT(atBase.base.position.z(), before.base.position.z()) << "pulled deeper";
    EXPECT_LT(atBase.deviceForce.z(), 0.99 * before.deviceForce.z());
}

TEST(GuidedTick, WithoutACouplingAGuideHasNothingToPullAt) {
    const Scene scene = test::coupledScene({});
    GuidedDevice device(scene);
    device.settings.guide = guideTo(FixtureKind::Point, kTarget);
    device.moveTo(kDeviceAt40nm, 1000);
    const Vector3 position = kDeviceAt40nm + Vector3(3e-3, 0.0, 0.0);
    EXPECT_LT((device.moveTo(position, 1000).base.position - 1e-6 * position).norm(), 1e-18);
}

}  // namespace
}  // namespace asperity
