#include "hardware/woodenhaptics/WoodenHaptics.h"

#include "core/words/DeviceWords.h"
#include "tests/hardware/Eventually.h"
#include "tests/hardware/FakeHid.h"
#include "tests/hardware/woodenhaptics/ArmPose.h"
#include "tests/hardware/woodenhaptics/Calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace asperity::test {
namespace {

const Vector3 kHandle(0.04, -0.02, 0.03);  // [m]
const Vector3 kSentForce(0.5, -0.3, 0.8);  // [N]
const Report kZeroCurrents(15, 0);

HidDeviceInfo mbedInfo() {
    return {.path = "/dev/hidraw7",
            .vendorId = 0x1234,
            .productId = 0x0006,
            .product = "Polhem",
            .usages = {{.page = 0xFFAB, .id = 0x200}}};
}

Report readingReport(const Vector3& handle, bool button = false) {
    Report report;
    const auto [a, b, c] = countsAt(handle);
    for (const int word : {int{a}, int{b}, int{c}, button ? 10000 : 0, 0, 0, 0}) {
        const auto bits = static_cast<unsigned>(word);
        report.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
        report.push_back(static_cast<std::uint8_t>((bits >> 8U) & 0xFFU));
    }
    return report;
}

/// Returns the message that makes the handle push like this where it is.
Report currentsFor(const Vector3& handle, const Vector3& force) {
    const Vector3 angles = jointAngles(shippedDevice(), countsAt(handle));
    const auto message =
        currentsMessage(WoodenHapticsBoard::Mbed,
                        motorCurrents(shippedDevice(),
                                      jointTorques(shippedDevice(), angles, inDeviceFrame(force))));
    return {message.report().begin(), message.report().end()};
}

/// A driver at a device in memory that answers on demand.
class WoodenHapticsDevice : public ::testing::Test {
protected:
    WoodenHapticsDevice() {
        hid.send({readingReport(kHandle)});
        device = std::make_unique<WoodenHaptics>(hid, shippedDevice());
        calibrate();
    }

    void calibrate() {
        const auto speak = [this] { hid.send({readingReport(kHandle)}); };
        EXPECT_TRUE(calibrateWhenItWaits(*device, speak));
    }

    /// One tick of a loop that wants the operator to feel the force.
    DeviceState tick(const Vector3& force) {
        hid.send({readingReport(kHandle)});
        const DeviceState state = device->advance(1e-3);
        device->setForce(force);
        return state;
    }
    bool wrote(const Report& message) const {
        const std::vector<Report> all = hid.written();
        return std::find(all.begin(), all.end(), message) != all.end();
    }
    void pushUntilItIsFelt() {
        ASSERT_TRUE(eventually([this] {
            (void)tick(kSentForce);
            return hid.written().back() == currentsFor(kHandle, kSentForce);
        }));
    }

    FakeHid hid{{mbedInfo()}};
    std::unique_ptr<WoodenHaptics> device;
};

TEST(WoodenHaptics, BeforeItIsCalibratedItIsNotConnectedAndPushesNothing) {
    FakeHid hid({mbedInfo()});
    hid.send({readingReport(kHandle)});
    WoodenHaptics device(hid, shippedDevice());
    EXPECT_FALSE(device.status().calibrated);
    EXPECT_EQ(wordsOf(device.status()),
              "Polhem at /dev/hidraw7: put the handle into its rest pose, then Device > Calibrate");
    for (int i = 0; i < 20; ++i) {
        hid.send({readingReport(kHandle)});
        EXPECT_FALSE(device.advance(1e-3).connected);
        device.setForce(kSentForce);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    for (const Report& message : hid.written()) {
        EXPECT_EQ(message, kZeroCurrents);
    }
}

TEST_F(WoodenHapticsDevice, IsWhereTheHandleIsAtOnce) {
    const DeviceState state = device->advance(1e-3);
    EXPECT_TRUE(state.connected);
    EXPECT_LT((state.position - kHandle).norm(), 0.1e-3);
    EXPECT_EQ(state.buttons, 0U);
    EXPECT_TRUE(device->status().calibrated);
    EXPECT_EQ(wordsOf(device->status()), "Polhem at /dev/hidraw7");
}

TEST_F(WoodenHapticsDevice, IsWhatItsDeviceFileSays) {
    const DeviceSpecification specification = device->specification();
    EXPECT_EQ(specification.maxForce, 5.0);
    EXPECT_TRUE(specification.streams);
}

TEST_F(WoodenHapticsDevice, TheButtonOfPolhemIsButtonZero) {
    hid.send({readingReport(kHandle, true)});
    EXPECT_TRUE(eventually([this] { return device->advance(1e-3).buttons == 1U; }));
}

TEST_F(WoodenHapticsDevice, OfManyReadingsTheNewestCounts) {
    const Vector3 newest(-0.03, 0.05, 0.0);
    std::vector<Report> reports(40, readingReport(kHandle));
    reports.push_back(readingReport(newest));
    hid.send(reports);
    EXPECT_TRUE(
        eventually([&] { return (device->advance(1e-3).position - newest).norm() < 0.1e-3; }));
}

TEST_F(WoodenHapticsDevice, PushesAsTheArmStands) {
    EXPECT_NE(currentsFor(kHandle, kSentForce), kZeroCurrents);
    pushUntilItIsFelt();
}

TEST_F(WoodenHapticsDevice, NoCurrentFlowsBeforeAForceIsTold) {
    const std::size_t before = hid.written().size();
    ASSERT_TRUE(eventually([&] {
        hid.send({readingReport(kHandle)});
        return hid.written().size() > before + 10;
    }));
    const std::vector<Report> all = hid.written();
    EXPECT_EQ(
        std::count(all.begin() + static_cast<std::ptrdiff_t>(before), all.end(), kZeroCurrents),
        static_cast<std::ptrdiff_t>(all.size() - before));
}

TEST_F(WoodenHapticsDevice, ALoopThatHangsLetsGo) {
    pushUntilItIsFelt();
    EXPECT_TRUE(eventually([this] {
        hid.send({readingReport(kHandle)});
        return hid.written().back() == kZeroCurrents;
    }));
}

TEST_F(WoodenHapticsDevice, ADeviceThatFallsSilentLetsGoAndTheDeviceGrowsOld) {
    pushUntilItIsFelt();
    EXPECT_TRUE(eventually([this] {
        const double age = device->advance(1e-3).age;
        device->setForce(kSentForce);
        return age > 40e-3 && hid.written().back() == kZeroCurrents;
    }));
    const double old = device->advance(1e-3).age;
    hid.send({readingReport(kHandle)});
    EXPECT_TRUE(eventually([&] { return device->advance(1e-3).age < old; }));
}

TEST_F(WoodenHapticsDevice, ADeviceThatComesBackIsHeldByNoForceFromBefore) {
    pushUntilItIsFelt();
    hid.unplug();
    ASSERT_TRUE(eventually([this] { return !device->advance(1e-3).connected; }));
    device->setForce(kSentForce);
    const std::size_t before = hid.written().size();
    hid.plug(mbedInfo());
    ASSERT_TRUE(eventually([&] {
        hid.send({readingReport(kHandle)});
        device->setForce(kSentForce);  // answers the reading from before
        return hid.written().size() > before + 20;
    }));
    const std::vector<Report> all = hid.written();
    EXPECT_EQ(
        std::count(all.begin() + static_cast<std::ptrdiff_t>(before), all.end(), kZeroCurrents),
        static_cast<std::ptrdiff_t>(all.size() - before));
    EXPECT_FALSE(device->advance(1e-3).connected) << "it may have lost its power";
    calibrate();
    pushUntilItIsFelt();
}

TEST_F(WoodenHapticsDevice, ALostDeviceIsNotConnectedAndStaysWhereItWas) {
    const Vector3 reached = device->advance(1e-3).position;
    hid.unplug();
    ASSERT_TRUE(eventually([this] { return !device->advance(1e-3).connected; }));
    EXPECT_EQ(device->advance(1e-3).position, reached);
    EXPECT_TRUE(eventually([this] {
        const std::string words = wordsOf(device->status());
        return words == "the WoodenHaptics was unplugged" ||
               words == "no WoodenHaptics is plugged in";
    }));
}

TEST_F(WoodenHapticsDevice, ADeviceThatTakesNoMessageIsLost) {
    hid.refuseToWrite(true);
    ASSERT_TRUE(eventually([this] { return !device->advance(1e-3).connected; }));
    hid.refuseToWrite(false);
    calibrate();
}

TEST_F(WoodenHapticsDevice, LetsGoInTheEnd) {
    pushUntilItIsFelt();
    device.reset();
    EXPECT_EQ(hid.written().back(), kZeroCurrents);
    EXPECT_EQ(hid.opened(), 0);
}

TEST_F(WoodenHapticsDevice, CalibrationTellsTheEncodersOfTheRestPoseOnce) {
    const auto message = encodersMessage(WoodenHapticsBoard::Mbed, {0, 0, 6000});
    const Report expected(message.report().begin(), message.report().end());
    EXPECT_TRUE(wrote(expected));
    pushUntilItIsFelt();
    const std::vector<Report> all = hid.written();
    EXPECT_EQ(std::count(all.begin(), all.end(), expected), 1);
}

TEST_F(WoodenHapticsDevice, DelayIsFromTheReadingToTheWrittenForce) {
    EXPECT_EQ(device->delay(), 0.0);
    hid.holdWrites(std::chrono::milliseconds(5));
    pushUntilItIsFelt();
    ASSERT_TRUE(eventually([this] { return device->delay() > 0.0; }));
    EXPECT_GE(device->delay(), 5e-3);
}

TEST(WoodenHaptics, AsksADeviceThatIsSilentWithZeroCurrents) {
    FakeHid hid({mbedInfo()});
    WoodenHaptics device(hid, shippedDevice());
    EXPECT_TRUE(eventually([&] { return hid.written().size() > 3; }));
    EXPECT_EQ(hid.written().front(), kZeroCurrents);
    EXPECT_FALSE(device.advance(1e-3).connected);
}

TEST(WoodenHaptics, IsNotMovedByReportsOfAnotherLength) {
    FakeHid hid({mbedInfo()});
    WoodenHaptics device(hid, shippedDevice());
    hid.send({Report(13, 1), Report(15, 1), Report(64, 1), {}});
    const std::size_t before = hid.written().size();
    ASSERT_TRUE(eventually([&] { return hid.written().size() > before + 3; }));
    EXPECT_FALSE(device.advance(1e-3).connected);
}

}  // namespace
}  // namespace asperity::test
