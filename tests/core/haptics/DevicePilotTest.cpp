#include "core/Units.h"
#include "core/haptics/DevicePath.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(DevicePilot, AddsUpWhatTheMouseMoves) {
    DevicePilot pilot({1.0_nm, 0.0, 5.0_nm});
    pilot.displace({2.0_nm, 0.0, 0.0});
    pilot.displace({0.0, 0.0, -1.0_nm});
    EXPECT_TRUE(pilot.advance(0.0, {}).isApprox(Vector3(3.0_nm, 0.0, 4.0_nm)));
}

TEST(DevicePilot, MovesWhileKeysAreHeld) {
    DevicePilot pilot(Vector3::Zero());
    pilot.setVelocity({0.0, 0.0, -2.0_nm});
    pilot.advance(0.5, {});
    pilot.setVelocity(Vector3::Zero());
    EXPECT_NEAR(pilot.advance(10.0, {}).z(), -1.0_nm, 1e-18);
}

TEST(DevicePilot, TravelsAndStays) {
    DevicePilot pilot({5.0_nm, 0.0, 0.0});
    pilot.follow({{2.0, {1.0_nm, 0.0, 0.0}}, {3.0, {1.0_nm, 8.0_nm, 0.0}}});
    EXPECT_NEAR(pilot.advance(0.5, {}).y(), 4.0_nm, 1e-18);
    EXPECT_TRUE(pilot.traveling());
    EXPECT_NEAR(pilot.advance(2.0, {}).y(), 8.0_nm, 1e-18);
    EXPECT_FALSE(pilot.traveling());
    EXPECT_TRUE(pilot.advance(1.0, {}).isApprox(Vector3(1.0_nm, 8.0_nm, 0.0)));
}

TEST(DevicePilot, BringsTheBaseToItsPlaceWhereverTheDeviceIsAndWhateverTheGain) {
    DevicePilot pilot({5.0_nm, 0.0, 0.0});
    pilot.follow({{0.0, {0.0, 0.0, 0.0}}, {1.0, {0.0, 8.0_nm, 0.0}}});
    // A device that lags behind, and a gain that has just become 2.
    const DeviceMapping now{
        .device = {5.0_nm, 1.0_nm, 0.0}, .base = {0.0, 2.0_nm, 0.0}, .positionGain = 2.0};
    const Vector3 device = pilot.advance(1.0, now);
    const Vector3 base = now.base + now.positionGain * (device - now.device);
    EXPECT_TRUE(base.isApprox(Vector3(0.0, 8.0_nm, 0.0)));
}

TEST(DevicePilot, ThePersonEndsAJourney) {
    DevicePilot pilot(Vector3::Zero());
    const DevicePath far{{0.0, {0.0, 0.0, 0.0}}, {1.0, {0.0, 8.0_nm, 0.0}}};
    pilot.follow(far);
    pilot.displace({1.0_nm, 0.0, 0.0});
    EXPECT_FALSE(pilot.traveling());
    pilot.follow(far);
    pilot.setVelocity(Vector3::Zero());
    EXPECT_TRUE(pilot.traveling()) << "no key is held";
    pilot.setVelocity({1.0_nm, 0.0, 0.0});
    EXPECT_FALSE(pilot.traveling());
}

TEST(DevicePilot, StaysNearADeviceThatCannotFollow) {
    DevicePilot pilot({30.0_nm, 40.0_nm, 9.0_nm});
    pilot.keepNear(Vector3::Zero(), 60.0_nm);
    EXPECT_EQ(pilot.target(), Vector3(30.0_nm, 40.0_nm, 9.0_nm));
    pilot.keepNear(Vector3::Zero(), 5.0_nm);
    EXPECT_TRUE(pilot.target().isApprox(Vector3(3.0_nm, 4.0_nm, 9.0_nm)));
}

}  // namespace
}  // namespace asperity
