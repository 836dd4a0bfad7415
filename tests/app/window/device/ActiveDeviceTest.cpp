#include "app/window/device/DeviceControl.h"
#include "core/haptics/device/HapticDevice.h"
#include "hardware/DeviceRegistry.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace asperity::test {
namespace {

class ActiveDeviceTest : public ::testing::Test {
protected:
    ActiveDeviceTest()
        : run({.scene = buildScene(plainScene(), flatMap()),
               .format = "made for the test",
               .sha256 = "",
               .notes = {}},
              Vector3(50e-9, 60e-9, 30e-9)) {
        device.attach(run);
        run.loop().start();
    }

    /// Frames of 10 ms.
    void live(int frames) {
        for (int i = 0; i < frames; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            device.advance(0.01, 50e-9);
        }
    }

    /// Lives until the base has moved along x by `wanted`. Returns by how much it has moved [m].
    double travelled(const Vector3& from, double wanted, double tolerance) {
        const auto moved = [&] { return run.basePosition().x() - from.x(); };
        for (int i = 0; i < 3000 && std::abs(moved() - wanted) > tolerance; ++i) {
            live(1);
        }
        live(20);  // and it stays there
        return moved();
    }

    LiveRun run;
    ActiveDevice device;
};

TEST_F(ActiveDeviceTest, BeginsWithMouseAndKeyboardThatMoveTheTip) {
    EXPECT_EQ(device.driver(), &pointerDriver());
    EXPECT_FALSE(device.isHardware());
    const Vector3 before = run.basePosition();
    device.displace({5e-9, 0.0, 0.0});
    EXPECT_NEAR(travelled(before, 5e-9, 0.1e-9), 5e-9, 0.1e-9);
}

TEST_F(ActiveDeviceTest, TheHandleOfAPilotedDeviceGoesAsFarAsTheTipAsks) {
    device.use(simulatedDriver());
    EXPECT_EQ(device.driver(), &simulatedDriver());
    live(30);
    const Vector3 before = run.basePosition();
    device.displace({5e-9, 0.0, 0.0});
    EXPECT_NEAR(travelled(before, 5e-9, 0.5e-9), 5e-9, 0.5e-9);
}

TEST_F(ActiveDeviceTest, APathHasNoDriver) {
    device.follow({{0.0, {40e-9, 60e-9, 30e-9}}, {0.1, {45e-9, 60e-9, 30e-9}}});
    EXPECT_TRUE(device.followsPath());
    EXPECT_EQ(device.driver(), nullptr);
    EXPECT_FALSE(device.isHardware());
}

TEST_F(ActiveDeviceTest, ADeviceTakenElsewhereIsNotPilotedHere) {
    const Vector3 here = run.devicePosition();
    run.takeDevice([&here] { return std::make_unique<PointerDevice>(here); });
    EXPECT_EQ(device.driver(), nullptr);
    EXPECT_FALSE(device.followsPath());
    const Vector3 before = run.basePosition();
    device.displace({5e-9, 0.0, 0.0});
    live(20);
    EXPECT_LT((run.basePosition() - before).norm(), 1e-15);
}

TEST(ActiveDevice, WithoutARunNothingHappens) {
    ActiveDevice device;
    device.displace({5e-9, 0.0, 0.0});
    device.setVelocity({5e-9, 0.0, 0.0});
    device.travelTo({0.0, 0.0});
    device.advance(0.01, 50e-9);
    EXPECT_EQ(device.driver(), nullptr);
    EXPECT_FALSE(device.followsPath());
    EXPECT_FALSE(device.isHardware());
}

TEST_F(ActiveDeviceTest, ADeviceThatCannotBeOpenedLeavesTheDeviceBefore) {
    const DeviceDriver broken{.key = "broken",
                              .label = "Broken",
                              .open = [](const DeviceSite&) -> std::unique_ptr<HapticDevice> {
                                  throw std::runtime_error("no such luck");
                              }};
    EXPECT_THROW(device.use(broken), std::runtime_error);
    EXPECT_EQ(device.driver(), &pointerDriver());
    EXPECT_TRUE(run.loop().running());
}

}  // namespace
}  // namespace asperity::test
