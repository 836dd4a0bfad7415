#include "core/io/heightmap/ScanImage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace asperity::test {

namespace {

/// 4 x 2 pixels of 1 um x 2 um.
ScanChannel smallChannel() {
    ScanChannel channel;
    channel.map = emptyMap({4, 2}, 4e-6, 4e-6);
    return channel;
}

}  // namespace

TEST(ScanOrigin, IsTheLowerLeftCornerWhateverPointIsGiven) {
    ScanChannel channel = smallChannel();
    setOrigin(channel, 10e-6, 20e-6, GivenPoint::Corner);
    EXPECT_DOUBLE_EQ(channel.originX, 10e-6);
    EXPECT_DOUBLE_EQ(channel.originY, 20e-6);
    setOrigin(channel, 10e-6, 20e-6, GivenPoint::Center);
    EXPECT_DOUBLE_EQ(channel.originX, 8e-6);
    EXPECT_DOUBLE_EQ(channel.originY, 18e-6);
    setOrigin(channel, 10e-6, 20e-6, GivenPoint::FirstPixel);
    EXPECT_DOUBLE_EQ(channel.originX, 9.5e-6);
    EXPECT_DOUBLE_EQ(channel.originY, 19e-6);
}

TEST(ScanOrigin, IsNotKnownWithoutASizeButForTheCorner) {
    ScanChannel channel = smallChannel();
    channel.map.pitchX = channel.map.pitchY = 0.0;
    setOrigin(channel, 10e-6, 20e-6, GivenPoint::Center);
    EXPECT_EQ(channel.originX, 0.0);
    setOrigin(channel, 10e-6, 20e-6, GivenPoint::Corner);
    EXPECT_EQ(channel.originX, 10e-6);
}

TEST(ScanOrigin, NumberThatIsNotFiniteCountsAsZero) {
    ScanChannel channel = smallChannel();
    setOrigin(channel, std::numeric_limits<double>::quiet_NaN(), 1e-6, GivenPoint::Corner);
    EXPECT_EQ(channel.originX, 0.0);
    EXPECT_EQ(channel.originY, 1e-6);
}

TEST(ScanOrigin, RotationIsNotedOnceUnlessItIsAWholeTurn) {
    std::vector<std::string> notes;
    noteRotation(notes, 0.0);
    noteRotation(notes, -360.0);
    noteRotation(notes, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(notes.empty());
    noteRotation(notes, 33.5);
    noteRotation(notes, 33.5);
    EXPECT_THAT(notes, testing::ElementsAre(testing::HasSubstr("33.5 degrees")));
}

}  // namespace asperity::test
