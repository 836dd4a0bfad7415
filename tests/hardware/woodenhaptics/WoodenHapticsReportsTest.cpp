#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr auto kTeensy = WoodenHapticsBoard::Teensy;
constexpr auto kMbed = WoodenHapticsBoard::Mbed;

Bytes bytesOf(const WoodenHapticsMessage& message) {
    return {message.report().begin(), message.report().end()};
}

Bytes filledTo(std::size_t size, Bytes bytes) {
    bytes.resize(size, 0);
    return bytes;
}

/// Encoders 1, -2, 0x1234, then d, e = 7, f = -7, info 1.
Bytes inputReport(std::uint8_t lowD, std::uint8_t highD) {
    return {0x01, 0x00, 0xFE, 0xFF, 0x34, 0x12, lowD, highD, 0x07, 0x00, 0xF9, 0xFF, 0x01, 0x00};
}

TEST(WoodenHapticsReports, BoardsAreKnownByTheirIds) {
    EXPECT_EQ(woodenHapticsBoard(0x16c0, 0x0486), kTeensy);
    EXPECT_EQ(woodenHapticsBoard(0x1234, 0x0006), kMbed);
    EXPECT_EQ(woodenHapticsBoard(0x16c0, 0x0006), std::nullopt);
    EXPECT_EQ(woodenHapticsBoard(0x1234, 0x0486), std::nullopt);
}

TEST(WoodenHapticsReports, EncodersAreLittleEndian) {
    const EncoderCounts expected = {1, -2, 0x1234};
    const auto mbed = readingOf(kMbed, inputReport(0, 0));
    const auto teensy = readingOf(kTeensy, filledTo(64, inputReport(0, 0)));
    ASSERT_TRUE(mbed && teensy);
    EXPECT_EQ(mbed->counts, expected);
    EXPECT_EQ(teensy->counts, expected);
}

TEST(WoodenHapticsReports, TheButtonIsAnOffsetOfTheFourthEncoder) {
    EXPECT_FALSE(readingOf(kMbed, inputReport(0x88, 0x13))->button) << 5000;
    EXPECT_TRUE(readingOf(kMbed, inputReport(0x89, 0x13))->button) << 5001;
    EXPECT_TRUE(readingOf(kMbed, inputReport(0x10, 0x27))->button) << 10000;
    EXPECT_FALSE(readingOf(kMbed, inputReport(0xF0, 0xD8))->button) << -10000;
}

TEST(WoodenHapticsReports, AReportOfAnotherLengthSaysNothing) {
    for (std::size_t size = 0; size <= 65; ++size) {
        const Bytes report(size, 1);
        EXPECT_EQ(readingOf(kMbed, report).has_value(), size == 14) << size;
        EXPECT_EQ(readingOf(kTeensy, report).has_value(), size == 64) << size;
    }
}

TEST(WoodenHapticsReports, CurrentsAreInMilliamperes) {
    const Bytes expected = {0x00, 0xE8, 0x03, 0xFF, 0xFF, 0x30, 0xF8, 0, 0, 0, 0, 0, 0, 0, 0};
    const Vector3 currents(1.0, -1.4e-3, -2.0);
    EXPECT_EQ(bytesOf(currentsMessage(kMbed, currents)), expected);
    EXPECT_EQ(bytesOf(currentsMessage(kTeensy, currents)), filledTo(65, expected));
}

TEST(WoodenHapticsReports, NoCurrentTurnsRoundWhenItIsTooLarge) {
    const Bytes expected = {0x00, 0xFF, 0x7F, 0x01, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(bytesOf(currentsMessage(kMbed, Vector3(1e9, -1e9, 0.0))), expected);
}

TEST(WoodenHapticsReports, EncodersAreSetByCommandOne) {
    const Bytes expected = {0x00, 0, 0, 0, 0, 0, 0, 0x01, 0x00, 0x05, 0x00, 0xFB, 0xFF, 0x70, 0x17};
    EXPECT_EQ(bytesOf(encodersMessage(kMbed, {5, -5, 6000})), expected);
    EXPECT_EQ(bytesOf(encodersMessage(kTeensy, {5, -5, 6000})), filledTo(65, expected));
}

}  // namespace
}  // namespace asperity::test
