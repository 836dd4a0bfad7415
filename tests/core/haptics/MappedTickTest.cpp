#include "tests/core/haptics/GuidedDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::GuidedDevice;
using test::kGains;

const Vector3 kDeviceAt4nm(64e-3, 64e-3, 4e-3);
const Vector3 kPressed(64e-3, 64e-3, -3e-3);
constexpr double kPullAt4nm = 0.02;  // of what the sample pulls from 4 nm [N]

/// Engaged, in the air.
GuidedDevice engagedDevice(const Scene& scene) {
    GuidedDevice guided(scene);
    guided.device.maxForce = 8.5;
    guided.moveTo(kDeviceAt4nm, 1500);
    return guided;
}

Workspace workspaceAround(const Vector3& center) {
    return {.center = center, .radius = 50e-3, .stiffness = 200.0, .forceLimit = 2.0};
}

TEST(MappedTick, AClutchedDeviceMovesNothingAndFeelsNothing) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    const TickOutput before = guided.glideTo(kPressed, 2000);
    ASSERT_GT(before.deviceForce.norm(), 0.1);
    guided.settings.clutched = true;
    const TickOutput first = guided.moveTo(kPressed);
    EXPECT_EQ(first.deviceForce, Vector3::Zero()) << "in the same tick";
    EXPECT_EQ(first.forceState, ForceState::Clutched);
    EXPECT_EQ(first.fault, Fault::None);
    const TickOutput away = guided.glideTo({30e-3, 90e-3, 40e-3}, 400);
    EXPECT_LT((away.base.position - before.base.position).norm(), 1e-15);
    EXPECT_EQ(away.deviceForce, Vector3::Zero());
}

TEST(MappedTick, AfterAClutchTheCommandGoesOnFromWhereItWas) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    const TickOutput before = guided.moveTo(kDeviceAt4nm);
    guided.settings.clutchButton = 2;
    guided.device.buttons = 1U << 2U;
    const Vector3 elsewhere(10e-3, 20e-3, 30e-3);
    guided.glideTo(elsewhere, 400);
    guided.device.buttons = 0;
    EXPECT_LT((guided.moveTo(elsewhere).base.position - before.base.position).norm(), 1e-18);
    const Vector3 step(1e-3, -2e-3, 0.5e-3);
    const TickOutput after = guided.glideTo(elsewhere + step, 4000);
    EXPECT_LT((after.base.position - before.base.position - 1e-6 * step).norm(), 1e-11)
        << "but for what the sample pulls from afar";
    EXPECT_EQ(after.forceState, ForceState::On) << "the force came on again";
}

TEST(MappedTick, AForceThatAClutchTookAwayComesOnByAndBy) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    guided.settings.clutched = true;
    guided.moveTo(kDeviceAt4nm, 20);
    guided.settings.clutched = false;
    EXPECT_EQ(guided.moveTo(kDeviceAt4nm, 500).forceState, ForceState::Engaging);
    EXPECT_EQ(guided.moveTo(kDeviceAt4nm, 600).forceState, ForceState::On);
}

TEST(MappedTick, ATurnedViewTurnsMotionAndForceAlike) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice straight = engagedDevice(scene);
    GuidedDevice turned(scene);
    turned.settings.deviceTurn = {0.3, -0.5, 0.8};
    const Matrix3 axes = axesOf(turned.settings.deviceTurn);
    turned.device.maxForce = 8.5;
    const auto asSeen = [&](const Vector3& position) -> Vector3 {
        return axes.transpose() * position;
    };
    turned.moveTo(asSeen(kDeviceAt4nm), 1500);
    const TickOutput one = straight.glideTo(kPressed, 4000);
    const TickOutput other = turned.glideTo(asSeen(kPressed), 4000);
    EXPECT_LT((one.base.position - other.base.position).norm(), 1e-15);
    EXPECT_LT((asSeen(one.deviceForce) - other.deviceForce).norm(), 1e-6 * one.deviceForce.norm());
}

TEST(MappedTick, AViewThatTurnsMovesNothing) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    const TickOutput before = guided.glideTo(kPressed, 4000);
    for (int i = 1; i <= 100; ++i) {
        guided.settings.deviceTurn = {0.0, 0.0, 0.01 * i};
        const TickOutput now = guided.moveTo(kPressed);
        ASSERT_LT((now.base.position - before.base.position).norm(), 1e-15) << i;
        ASSERT_NEAR(now.deviceForce.norm(), before.deviceForce.norm(), 1e-6) << i;
    }
}

TEST(MappedTick, TheEdgeOfTheWorkspacePushesBack) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    guided.settings.workspace = workspaceAround(kDeviceAt4nm);
    EXPECT_LT(guided.glideTo(kDeviceAt4nm + Vector3(44e-3, 0.0, 0.0), 1000).deviceForce.norm(),
              kPullAt4nm);
    const TickOutput out = guided.glideTo(kDeviceAt4nm + Vector3(48e-3, 0.0, 0.0), 4000);
    EXPECT_NEAR(out.deviceForce.x(), -0.6 / std::hypot(1.0, 0.6 / 2.0), kPullAt4nm);
    EXPECT_NEAR(out.deviceForce.z(), 0.0, kPullAt4nm);
}

TEST(MappedTick, AClutchedDeviceStillFeelsTheEdge) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    guided.settings.workspace = workspaceAround(kDeviceAt4nm);
    guided.settings.clutched = true;
    EXPECT_LT(guided.glideTo(kDeviceAt4nm + Vector3(0.0, 48e-3, 0.0), 200).deviceForce.y(), -0.5);
    guided.settings.forcesOn = false;
    EXPECT_EQ(guided.moveTo(kDeviceAt4nm + Vector3(0.0, 48e-3, 0.0)).deviceForce, Vector3::Zero());
}

TEST(MappedTick, ADeviceThatStartsBeyondTheEdgeIsNotPushedUntilItComesIn) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided(scene);
    guided.device.maxForce = 8.5;
    guided.settings.workspace = workspaceAround(kDeviceAt4nm);
    const Vector3 beyond = kDeviceAt4nm + Vector3(50e-3, 0.0, 0.0);
    EXPECT_LT(guided.moveTo(beyond, 2000).deviceForce.norm(), kPullAt4nm);
    guided.glideTo(kDeviceAt4nm, 1500);
    EXPECT_LT(guided.glideTo(beyond, 500).deviceForce.x(), -0.5);
}

TEST(MappedTick, CouplingAndEdgeTogetherStayWithinTheLimit) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    guided.settings.workspace = workspaceAround(kDeviceAt4nm);
    guided.settings.workspace.forceLimit = 3.0;
    const TickOutput out = guided.glideTo(kDeviceAt4nm - Vector3(0.0, 0.0, 90e-3), 2000);
    EXPECT_EQ(out.forceState, ForceState::Limited);
    EXPECT_NEAR(out.deviceForce.norm(), scene.settings.governor.maxForce, 1e-12);
}

TEST(MappedTick, AHandleThatComesBackElsewhereAfterItWasLostMovesNothing) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    const TickOutput before = guided.moveTo(kDeviceAt4nm);
    guided.device.connected = false;
    guided.moveTo(kDeviceAt4nm, 20);
    guided.device.connected = true;
    const TickOutput after = guided.moveTo(kDeviceAt4nm - Vector3(0.0, 0.0, 54e-3), 20);
    EXPECT_EQ(after.fault, Fault::DeviceLost);
    EXPECT_LT((after.base.position - before.base.position).norm(), 1e-18);
}

TEST(MappedTick, AHandleThatWasMovedWhileTheLoopRestedMovesNothing) {
    const Scene scene = test::coupledScene(kGains);
    GuidedDevice guided = engagedDevice(scene);
    const TickOutput before = guided.moveTo(kDeviceAt4nm);
    ++guided.starts;
    const TickOutput after = guided.moveTo(kDeviceAt4nm + Vector3(20e-3, 0.0, -50e-3), 10);
    EXPECT_LT((after.base.position - before.base.position).norm(), 1e-18);
    EXPECT_EQ(after.forceState, ForceState::Engaging);
}

}  // namespace
}  // namespace asperity
