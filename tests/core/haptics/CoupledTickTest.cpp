#include "tests/core/haptics/GuidedDevice.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace asperity {
namespace {

constexpr CouplingGains kSofter{.stiffness = 250.0, .damping = 1.0, .proxyDamping = 2.0};

using test::coupledScene;
using test::GuidedDevice;
using test::kGains;

TEST(CoupledTick, TheProxyCommandsTheBaseAndTheDeviceFeelsTheCoupling) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    const Vector3 device(64e-3, 64e-3, -3e-3);
    guided.moveTo({64e-3, 64e-3, 4e-3});
    const TickOutput out = guided.moveTo(device, 4000);
    const Vector3 proxy = out.base.position / scene.settings.positionGain;
    EXPECT_GT(proxy.z(), device.z() + 1e-3) << "held up by the sample";
    const Vector3 coupling = kGains.stiffness * (proxy - device);
    EXPECT_LT((out.deviceForce - coupling).norm(), 1e-6 * coupling.norm());
    const Vector3 contact = scene.settings.forceGain * out.model.force;
    EXPECT_LT((out.deviceForce - contact).norm(), 1e-3 * contact.norm());
}

TEST(CoupledTick, WithoutACouplingTheDeviceCommandsTheBase) {
    const Scene scene = coupledScene({});
    GuidedDevice guided(scene);
    guided.moveTo({64e-3, 64e-3, 4e-3});
    const Vector3 device(64e-3, 64e-3, -1e-3);
    EXPECT_LT((guided.moveTo(device).base.position - 1e-6 * device).norm(), 1e-20);
}

TEST(CoupledTick, ChangedGainsMoveNothingByThemselves) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    const Vector3 device(64e-3, 64e-3, -3e-3);
    guided.moveTo({64e-3, 64e-3, 4e-3});
    const TickOutput before = guided.moveTo(device, 4000);
    const auto expectStill = [&](const char* what, double forceScale) {
        const TickOutput after = guided.moveTo(device, 100);
        EXPECT_LT((after.base.position - before.base.position).norm(), 1e-15) << what;
        const Vector3 force = forceScale * before.deviceForce;
        EXPECT_LT((after.deviceForce - force).norm(), 2e-3 * force.norm()) << what;
    };
    guided.settings.forceGain = 2e8;
    expectStill("twice the force gain", 2.0);
    guided.settings.positionGain = 1.2e-6;  // more, and the contact is stiffer than the proxy bears
    expectStill("a larger position gain", 2.0);
    guided.settings.coupling = kSofter;
    expectStill("a softer coupling", 2.0);
    guided.settings.coupling = {};
    expectStill("no coupling", 2.0);
    guided.settings.coupling = kGains;
    expectStill("a coupling again", 2.0);
}

TEST(CoupledTick, AForceGainThatIsTurnedUpNeitherStepsNorMovesTheBase) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    guided.settings.forceGain = 1e6;
    const Vector3 device(64e-3, 64e-3, -3e-3);
    guided.moveTo({64e-3, 64e-3, 4e-3});
    const TickOutput before = guided.moveTo(device, 4000);
    guided.settings.forceGain = 1e8;
    Vector3 last = before.deviceForce;
    double steepest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const TickOutput now = guided.moveTo(device);
        steepest = std::max(steepest, (now.deviceForce - last).norm() / now.deviceForce.norm());
        EXPECT_LT((now.base.position - before.base.position).norm(), 1e-13) << i;
        last = now.deviceForce;
    }
    EXPECT_LT(steepest, 0.011) << "a factor of e in 0.1 s";
    EXPECT_LT((last - 100.0 * before.deviceForce).norm(), 0.01 * last.norm());
}

TEST(CoupledTick, FreeAirDragsNoMoreThanADeviceCanBear) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    constexpr double kSpeed = 50e-3;  // [m/s]
    TickOutput out;
    for (int i = 0; i < 1000; ++i) {
        out = guided.moveTo({30e-3 + kSpeed * i * 1e-3, 64e-3, 60e-3});
    }
    const double drag = -out.deviceForce.x() / kSpeed;
    std::cout << "drag in free air " << drag << " N s/m\n";
    EXPECT_LE(drag, 5.0);
    EXPECT_NEAR(drag, kGains.proxyDamping, 0.01);
}

TEST(CoupledTick, ForcesOffLeaveTheProxyWhereItIs) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    const Vector3 device(64e-3, 64e-3, -3e-3);
    guided.moveTo({64e-3, 64e-3, 4e-3});
    const TickOutput before = guided.moveTo(device, 4000);
    guided.settings.forcesOn = false;
    const TickOutput after = guided.moveTo(device, 100);
    EXPECT_EQ(after.deviceForce, Vector3::Zero());
    EXPECT_LT((after.base.position - before.base.position).norm(), 1e-15);
}

TEST(CoupledTick, ASlidingTipFeelsFrictionWithoutChatter) {
    const Scene scene = coupledScene(kGains);
    GuidedDevice guided(scene);
    guided.moveTo({44e-3, 64e-3, 4e-3});
    guided.moveTo({44e-3, 64e-3, -5e-3}, 2000);
    constexpr double kSpeed = 10e-3;  // [m/s]
    double most = -1e9;
    double least = 1e9;
    TickOutput out;
    for (int i = 0; i < 2000; ++i) {
        out = guided.moveTo({44e-3 + kSpeed * i * 1e-3, 64e-3, -5e-3});
        if (i >= 1000) {
            most = std::max(most, out.deviceForce.x());
            least = std::min(least, out.deviceForce.x());
        }
    }
    const double load = scene.settings.forceGain * out.model.normalForce;
    const double share = kSpeed / std::hypot(kSpeed, 1e-3);  // v0 = 1 nm/s, 1 mm/s of the device
    const double friction = scene.description.sample.material.friction.coefficient * load * share;
    const double drag = kGains.proxyDamping * kSpeed;
    EXPECT_NEAR(out.deviceForce.x(), -friction - drag, 0.01 * friction);
    EXPECT_LT(most - least, 0.01 * friction);
}

TEST(CoupledTick, StopsOnAHillWithoutChatter) {
    const Scene scene = coupledScene(kGains, test::hillyMap());
    GuidedDevice guided(scene);
    guided.moveTo({52e-3, 57e-3, 12e-3});
    for (int i = 0; i < 2000; ++i) {
        guided.moveTo({52e-3 + i * 5e-6, 57e-3, 12e-3 - i * 8e-6});
    }
    Vector3 last = guided.moveTo({62e-3, 57e-3, -4e-3}, 8000).deviceForce;
    ASSERT_GT(last.norm(), 0.5);
    for (int i = 0; i < 500; ++i) {
        const Vector3 now = guided.moveTo({62e-3, 57e-3, -4e-3}).deviceForce;
        ASSERT_LT((now - last).norm(), 1e-4 * last.norm()) << i;
        last = now;
    }
}

}  // namespace
}  // namespace asperity
