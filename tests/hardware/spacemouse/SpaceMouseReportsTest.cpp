#include "hardware/spacemouse/SpaceMouse.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {
namespace {

using Report = std::vector<std::uint8_t>;

SpaceMouseState after(const std::vector<Report>& reports) {
    SpaceMouseState state;
    for (const Report& report : reports) {
        state = afterReport(state, report);
    }
    return state;
}

TEST(SpaceMouseReports, NewerDevicesSendSixAxesInOneReport) {
    // 350, -175, 70 and 35, -350, 175 in the device's frame
    const SpaceMouseState state =
        after({{1, 0x5E, 0x01, 0x51, 0xFF, 0x46, 0x00, 0x23, 0x00, 0xA2, 0xFE, 0xAF, 0x00}});
    EXPECT_EQ(state.translation, Vector3(1.0, 0.5, -0.2));
    EXPECT_EQ(state.rotation, Vector3(0.1, 1.0, -0.5));
}

TEST(SpaceMouseReports, OlderDevicesSendTranslationAndRotationApart) {
    const SpaceMouseState state =
        after({{1, 0x5E, 0x01, 0x00, 0x00, 0x00, 0x00}, {2, 0x00, 0x00, 0xA2, 0xFE, 0x00, 0x00}});
    EXPECT_EQ(state.translation, Vector3(1.0, 0.0, 0.0));
    EXPECT_EQ(state.rotation, Vector3(0.0, 1.0, 0.0));
}

TEST(SpaceMouseReports, APushAwayFromThePersonIsUpInTheImageAndAPullUpIsUp) {
    // The device counts towards the operator and downwards.
    EXPECT_EQ(after({{1, 0, 0, 0xA2, 0xFE, 0, 0}}).translation, Vector3(0.0, 1.0, 0.0));
    EXPECT_EQ(after({{1, 0, 0, 0, 0, 0xA2, 0xFE}}).translation, Vector3(0.0, 0.0, 1.0));
}

TEST(SpaceMouseReports, DeflectionsEndAtOne) {
    EXPECT_EQ(after({{1, 0xFF, 0x7F, 0x00, 0x80, 0xFF, 0x7F}}).translation,
              Vector3(1.0, 1.0, -1.0));
}

TEST(SpaceMouseReports, ButtonsComeInBytesLowestFirst) {
    EXPECT_EQ(after({{3, 0x02, 0x00}}).buttons, 2U);
    EXPECT_EQ(after({{3, 0x01, 0x80, 0x00, 0x40}}).buttons, 0x40008001U);
    EXPECT_EQ(after({{3, 0x01, 0x02, 0x03, 0x04, 0xFF, 0xFF}}).buttons, 0x04030201U);
    EXPECT_EQ(after({{3, 0x02, 0x00}, {3, 0x00, 0x00}}).buttons, 0U);
}

TEST(SpaceMouseReports, EachReportChangesOnlyWhatItSpeaksOf) {
    const SpaceMouseState state = after({{1, 0x5E, 0x01, 0, 0, 0, 0},
                                         {2, 0, 0, 0, 0, 0x5E, 0x01},
                                         {3, 0x01, 0x00},
                                         {2, 0, 0, 0, 0, 0, 0}});
    EXPECT_EQ(state.translation, Vector3(1.0, 0.0, 0.0));
    EXPECT_EQ(state.rotation, Vector3::Zero());
    EXPECT_EQ(state.buttons, 1U);
}

TEST(SpaceMouseReports, ShortLongAndUnknownReportsChangeNothing) {
    const SpaceMouseState before = after({{1, 0x5E, 0x01, 0, 0, 0, 0}, {3, 0x01, 0x00}});
    std::vector<Report> strange = {{}, {1}, {2}, {3}, {0, 1, 2, 3, 4, 5, 6}, {0x17, 100}};
    for (std::size_t length = 2; length <= 64; ++length) {
        if (length != 7 && length != 13) {
            strange.emplace_back(length, 0x11).front() = 1;
        }
        if (length != 7) {
            strange.emplace_back(length, 0x11).front() = 2;
        }
    }
    for (const Report& report : strange) {
        const SpaceMouseState state = afterReport(before, report);
        EXPECT_EQ(state.translation, before.translation);
        EXPECT_EQ(state.rotation, before.rotation);
        EXPECT_EQ(state.buttons, before.buttons);
    }
}

}  // namespace
}  // namespace asperity
