#include "hardware/spacemouse/SpaceMouse.h"

#include "core/words/DeviceWords.h"
#include "tests/hardware/Eventually.h"
#include "tests/hardware/FakeHid.h"

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

const Vector3 kStart(1e-6, 2e-6, 3e-6);
constexpr double kSpeed = 100e-9;  // [m/s]
constexpr int kFull = 350;         // [count]

/// Speed of the device, as a share of the full speed.
Vector3 velocityShare(SpaceMouse& mouse) {
    const Vector3 from = mouse.advance(0.0).position;
    return (mouse.advance(1.0).position - from) / kSpeed;
}

class SpaceMouseDevice : public ::testing::Test {
protected:
    /// Sends all at once, with a mark in the buttons last, and waits until the device has that.
    void send(std::vector<Report> reports) {
        const std::uint8_t mark = ++marks_;
        reports.push_back({3, mark, 0});
        hid.send(reports);
        ASSERT_TRUE(eventually([&] { return mouse.advance(0.0).buttons == mark; }));
    }

    /// The speed, as a share of the full one, for a deflection to the right [count].
    double speedShareAt(int counts) {
        send({motionReport(counts, 0, 0)});
        return velocityShare(mouse).x();
    }

    FakeHid hid{{spaceMouseInfo()}};
    SpaceMouse mouse{hid, kStart, kSpeed};

private:
    std::uint8_t marks_ = 0;
};

TEST_F(SpaceMouseDevice, IsConnectedAtOnceAndRestsWhereItStarts) {
    const DeviceState state = mouse.advance(1.0);
    EXPECT_TRUE(state.connected);
    EXPECT_EQ(state.position, kStart);
    EXPECT_EQ(state.buttons, 0U);
    EXPECT_EQ(wordsOf(mouse.status()), "SpaceMouse Compact at /dev/hidraw7");
}

TEST_F(SpaceMouseDevice, FullDeflectionIsFullSpeedAlongTheAxesOfTheLab) {
    send({motionReport(kFull, 0, 0)});
    EXPECT_TRUE(velocityShare(mouse).isApprox(Vector3(1.0, 0.0, 0.0), 1e-9));
    send({motionReport(0, -kFull, 0)});
    EXPECT_TRUE(velocityShare(mouse).isApprox(Vector3(0.0, 1.0, 0.0), 1e-9));
    send({motionReport(0, 0, kFull)});
    EXPECT_TRUE(velocityShare(mouse).isApprox(Vector3(0.0, 0.0, -1.0), 1e-9));
}

TEST_F(SpaceMouseDevice, GoesAsFarInManyStepsAsInOne) {
    send({motionReport(kFull, kFull, 0)});
    for (int i = 0; i < 500; ++i) {
        (void)mouse.advance(2e-3);
    }
    const Vector3 way = mouse.advance(0.0).position - kStart;
    EXPECT_TRUE(way.isApprox(kSpeed * Vector3(1.0, -1.0, 0.0), 1e-9));
}

TEST_F(SpaceMouseDevice, RestsInTheDeadZoneAndStartsSmoothlyOutOfIt) {
    EXPECT_EQ(speedShareAt(17), 0.0);
    EXPECT_EQ(speedShareAt(-17), 0.0);
    EXPECT_GT(speedShareAt(18), 0.0);
    EXPECT_LT(speedShareAt(18), 1e-3);
}

TEST_F(SpaceMouseDevice, IsGentleToALightTouch) {
    EXPECT_LT(speedShareAt(kFull / 10), 0.02);
    EXPECT_LT(speedShareAt(kFull / 2), 0.25);
    EXPECT_GT(speedShareAt(kFull / 2), 0.1);
    EXPECT_NEAR(speedShareAt(-kFull / 2), -speedShareAt(kFull / 2), 1e-9);
}

TEST_F(SpaceMouseDevice, APushStraightDownStaysStraightWhenTheKnobTiltsALittle) {
    send({motionReport(15, -12, kFull)});
    EXPECT_TRUE(velocityShare(mouse).isApprox(Vector3(0.0, 0.0, -1.0), 1e-9));
}

TEST_F(SpaceMouseDevice, StopsWhenTheKnobIsLetGo) {
    send({motionReport(kFull, 0, 0)});
    EXPECT_GT(velocityShare(mouse).x(), 0.0);
    send({motionReport(0, 0, 0)});
    EXPECT_EQ(velocityShare(mouse), Vector3::Zero());
}

TEST_F(SpaceMouseDevice, TakesANewSpeedWhileItIsMoved) {
    send({motionReport(kFull, 0, 0)});
    mouse.setSpeed(3.0 * kSpeed);
    EXPECT_NEAR(velocityShare(mouse).x(), 3.0, 1e-9);
}

TEST_F(SpaceMouseDevice, TheTipIsAsFastOnTheScreenWhateverIsSeen) {
    send({motionReport(kFull, 0, 0)});
    mouse.setSeenHalfWidth(8.0 * kSpeed);
    EXPECT_NEAR(velocityShare(mouse).x(), 4.0, 1e-9);
}

TEST_F(SpaceMouseDevice, OfManyReportsTheNewestCounts) {
    for (const std::size_t count : {40U, 200U}) {
        std::vector<Report> flood(count, motionReport(-kFull, kFull, kFull));
        flood.push_back(motionReport(kFull, 0, 0));
        send(flood);
        EXPECT_TRUE(velocityShare(mouse).isApprox(Vector3(1.0, 0.0, 0.0), 1e-9));
    }
}

TEST_F(SpaceMouseDevice, WhereTheSystemMayHaveDroppedReportsTheKnobCountsAsLetGo) {
    send(std::vector<Report>(62, motionReport(kFull, 0, 0)));  // 63 with the mark: a full queue
    EXPECT_EQ(velocityShare(mouse), Vector3::Zero());
    send({motionReport(kFull, 0, 0)});
    EXPECT_GT(velocityShare(mouse).x(), 0.0);
}

TEST_F(SpaceMouseDevice, IsNotMovedByGarbage) {
    send({{},
          {1},
          {1, 0x5E},
          {1, 0x5E, 1, 0x5E, 1, 0x5E},
          {9, 0x5E, 1, 0x5E, 1, 0x5E, 1},
          Report(64, 0xFF),
          Report(200, 1)});
    EXPECT_EQ(velocityShare(mouse), Vector3::Zero());
    EXPECT_TRUE(mouse.advance(0.0).connected);
}

TEST_F(SpaceMouseDevice, LosesTheDeviceAtAnUnplugAndFindsItAgain) {
    send({motionReport(kFull, 0, 0)});
    const Vector3 reached = mouse.advance(1.0).position;
    hid.unplug();
    ASSERT_TRUE(eventually([this] { return !mouse.advance(0.0).connected; }));
    const DeviceState lost = mouse.advance(1.0);
    EXPECT_EQ(lost.position, reached);
    EXPECT_EQ(lost.buttons, 0U);

    hid.plug(spaceMouseInfo());
    ASSERT_TRUE(eventually([this] { return mouse.advance(0.0).connected; }));
    EXPECT_EQ(mouse.advance(1.0).position, reached);
    send({motionReport(-kFull, 0, 0)});
    EXPECT_NEAR(velocityShare(mouse).x(), -1.0, 1e-9);
}

TEST(SpaceMouse, LightsTheDeviceWhileItIsUsed) {
    const std::vector<Report> on = {{4, 1}};
    const std::vector<Report> onAndOff = {{4, 1}, {4, 0}};
    FakeHid hid({spaceMouseInfo()});
    {
        const SpaceMouse mouse(hid, kStart);
        ASSERT_TRUE(eventually([&] { return hid.written() == on; }));
        EXPECT_EQ(hid.opened(), 1);
    }
    EXPECT_EQ(hid.written(), onAndOff);
    EXPECT_EQ(hid.opened(), 0);
}

TEST(SpaceMouse, WaitsForADeviceThatIsPluggedInLater) {
    FakeHid hid;
    SpaceMouse mouse(hid, kStart);
    EXPECT_FALSE(mouse.advance(1.0).connected);
    EXPECT_EQ(wordsOf(mouse.status()), "no SpaceMouse is plugged in");
    hid.plug({.path = "/dev/hidraw0", .vendorId = 0x1234, .productId = 1});
    hid.plug(spaceMouseInfo());
    EXPECT_TRUE(eventually([&mouse] { return mouse.advance(0.0).connected; }));
    EXPECT_EQ(mouse.advance(0.0).position, kStart);
}

TEST(SpaceMouse, SaysWhenPermissionIsMissing) {
    HidDeviceInfo device = spaceMouseInfo();
    device.permitted = false;
    FakeHid hid({device});
    SpaceMouse mouse(hid, kStart);
    EXPECT_FALSE(mouse.advance(0.0).connected);
    EXPECT_EQ(wordsOf(mouse.status()), std::string("/dev/hidraw7: ") + kNoPermission);
}

TEST(SpaceMouse, TriesAgainWhenTheDeviceCannotBeOpened) {
    FakeHid hid({spaceMouseInfo()});
    hid.refuseToOpen("the device is asleep");
    SpaceMouse mouse(hid, kStart);
    EXPECT_FALSE(mouse.advance(0.0).connected);
    EXPECT_EQ(wordsOf(mouse.status()), "the device is asleep");
    hid.refuseToOpen("");
    EXPECT_TRUE(eventually([&mouse] { return mouse.advance(0.0).connected; }));
    EXPECT_EQ(wordsOf(mouse.status()), "SpaceMouse Compact at /dev/hidraw7");
}

}  // namespace
}  // namespace asperity::test
