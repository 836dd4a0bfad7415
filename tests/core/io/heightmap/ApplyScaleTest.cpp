#include "core/Error.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/ScanImage.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr GivenScale kGivenSize{.sizeX = 8e-6, .sizeY = 4e-6};
constexpr GivenScale kHeight{.heightPerValue = 2.5e-10};
constexpr GivenScale kBoth{.sizeX = 8e-6, .sizeY = 4e-6, .heightPerValue = 2.5e-10};

/// A map of 4 columns and 2 rows, of nothing but numbers.
std::filesystem::path bareMatrix(const ScratchFolder& folder) {
    return folder.write("bare.txt", "1 2 3 4\n5 6 7 -6.5\n");
}

/// An image of 2 x 3 pixels with values of 1 to 6.
std::string gwyImage(int number, const std::string& title, const std::string& unit) {
    const std::string key = "/" + std::to_string(number) + "/data";
    const std::string units =
        gwyUnit("si_unit_xy", "m") + (unit.empty() ? "" : gwyUnit("si_unit_z", unit));
    return gwyComponent(key,
                        gwyObjectBytes("GwyDataField",
                                       gwyInteger("xres", 2) + gwyInteger("yres", 3) +
                                           gwyNumber("xreal", 4e-9) + gwyNumber("yreal", 9e-9) +
                                           units + gwyNumbers("data", {1, 2, 3, 4, 5, 6}))) +
           gwyText(key + "/title", title);
}

ScanChannel channelWith(const std::filesystem::path& path, const GivenScale& given,
                        const std::string& name = "") {
    return ScanFile(path, given, {}).readHeightChannel(name).channel;
}

}  // namespace

TEST(ApplyScale, NumbersBecomeHeightsAndPixelsHaveASize) {
    const ScratchFolder folder;
    const ScanChannel channel = channelWith(bareMatrix(folder), kBoth);
    EXPECT_TRUE(channel.isHeight());
    EXPECT_TRUE(channel.hasSize());
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 2e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 2e-6);
    std::vector<double> heights = {1, 2, 3, 4, 5, 6, 7, -6.5};
    for (double& height : heights) {
        height *= 2.5e-10;
    }
    EXPECT_EQ(channel.map.heights, heights) << "to the last bit";
}

TEST(ApplyScale, NotesAndProvenanceSayWhatTheUserGave) {
    const ScratchFolder folder;
    const ScanChannel channel = channelWith(bareMatrix(folder), kBoth);
    EXPECT_THAT(channel.notes, Contains(HasSubstr("size 8 µm x 4 µm as given")));
    EXPECT_THAT(channel.notes, Contains("numbers taken as heights of 2.5e-10 m each as given"));
    EXPECT_THAT(channel.notes, Not(Contains(std::string(kNoSizeNote))));
    const auto from = [](const char* what) {
        return testing::AllOf(testing::Field(&Provenance::what, what),
                              testing::Field(&Provenance::source, "given by the user"));
    };
    EXPECT_THAT(channel.provenance, Contains(from("lateral size")));
    EXPECT_THAT(channel.provenance, Contains(from("scale")));
}

TEST(ApplyScale, PixelsThatAreNotSquareAreSaid) {
    const ScratchFolder folder;
    const GivenScale square{.sizeX = 8e-6, .sizeY = 8e-6, .heightPerValue = 1e-9};
    EXPECT_THAT(channelWith(bareMatrix(folder), square).notes,
                Contains("its pixels are not square: 2 µm x 4 µm"));
    EXPECT_THAT(channelWith(bareMatrix(folder), kBoth).notes, Not(Contains(HasSubstr("square"))));
}

TEST(ApplyScale, NothingGivenChangesNothing) {
    const ScratchFolder folder;
    const ScanFile file(bareMatrix(folder), GivenScale{}, {});
    EXPECT_FALSE(file.contents().channels.front().hasSize());
    EXPECT_EQ(file.contents().channels.front().unit, "");
    EXPECT_THAT(file.contents().channels.front().notes, Contains(std::string(kNoSizeNote)));
}

TEST(ApplyScale, ASizeStandsInPlaceOfThatOfTheFileAndSaysSo) {
    const ScratchFolder folder;
    const auto path = folder.write("known.gwy", gwyFile(gwyImage(0, "Height", "m")));
    const ScanChannel channel = channelWith(path, kGivenSize);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 4e-6);
    EXPECT_DOUBLE_EQ(channel.map.heights.front(), 1.0);
    EXPECT_THAT(channel.notes, Contains(HasSubstr("that of the file is 4 nm x 9 nm")));
}

/// They would be wrong by a billion, with a note at most.
TEST(ApplyScale, NoHeightsAreGivenToAFileWhoseValuesHaveUnits) {
    const ScratchFolder folder;
    const auto path = folder.write(
        "known.gwy", gwyFile(gwyImage(0, "Height", "m") + gwyImage(1, "Voltage", "V")));
    EXPECT_THAT(refusalOf([&] { (void)ScanFile(path, kHeight, {}); }),
                testing::AllOf(HasSubstr("known.gwy: its values have units"),
                               HasSubstr("--z-unit, --z-scale and z_scale_m")));
}

/// The scale is that of the numbers: heights that the file knows would be wrong by a billion.
TEST(ApplyScale, HeightsOfAFileStayBesideNumbersThatBecomeHeights) {
    const ScratchFolder folder;
    const auto path =
        folder.write("mixed.gwy", gwyFile(gwyImage(0, "Height", "m") + gwyImage(1, "Numbers", "") +
                                          gwyImage(2, "Voltage", "V")));
    EXPECT_EQ(channelWith(path, kHeight).name, "Height") << "taken as without the scale";
    EXPECT_EQ(channelWith(path, kHeight).map.heights.front(), 1.0);
    EXPECT_EQ(channelWith(path, kHeight, "Numbers").map.heights.front(), 2.5e-10);
    EXPECT_THAT(refusalOf([&] { (void)channelWith(path, kHeight, "Voltage"); }),
                HasSubstr("the unit V"));
}

}  // namespace asperity::test
