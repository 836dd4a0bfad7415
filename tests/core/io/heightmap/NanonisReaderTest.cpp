#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity::test {

namespace {

using testing::HasSubstr;

HeightMapFile readAsNanonis(const NanonisText& text, const std::vector<double>& numbers = {
                                                         1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) {
    return readHeightMapBytes(nanonisFile(text, numbers), "scan.sxm");
}

std::string refusalOfNanonis(const NanonisText& text) {
    return refusalOf([&] { (void)readAsNanonis(text); });
}

}  // namespace

TEST(NanonisReader, BackwardImageIsMirroredBack) {
    const HeightMapFile file = readAsNanonis({});
    ASSERT_EQ(file.channels.size(), 2U);
    const ScanChannel& forward = file.channels[0];
    const ScanChannel& backward = file.channels[1];
    EXPECT_EQ(forward.name, "Z (Forward)");
    EXPECT_EQ(forward.direction, "forward");
    EXPECT_DOUBLE_EQ(forward.map.at(0, 0), 1.0);
    EXPECT_DOUBLE_EQ(forward.map.at(1, 2), 6.0);
    EXPECT_EQ(backward.name, "Z (Backward)");
    EXPECT_EQ(backward.direction, "backward");
    EXPECT_DOUBLE_EQ(backward.map.at(0, 0), 9.0);
    EXPECT_DOUBLE_EQ(backward.map.at(1, 2), 10.0);
}

TEST(NanonisReader, UpwardScanStoresItsBottomRowFirst) {
    NanonisText text;
    text.direction = "up";
    const HeightMapFile file = readAsNanonis(text);
    EXPECT_DOUBLE_EQ(file.channels.at(0).map.at(0, 0), 4.0);
    EXPECT_DOUBLE_EQ(file.channels.at(1).map.at(0, 0), 12.0);
}

TEST(NanonisReader, SizeAndOriginAreMeters) {
    const ScanChannel channel = readAsNanonis({}).channels.at(0);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.lateralUnit, "m");
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_DOUBLE_EQ(channel.originX, -5.280251e-7 - 1.5e-8);  // the offset is that of the center
    EXPECT_DOUBLE_EQ(channel.originY, 1.130423e-8 - 1e-8);
    EXPECT_EQ(channel.metadata.at("COMMENT"), "first line\nsecond line");
}

TEST(NanonisReader, FirstVersionNamesRowsBeforeColumns) {
    NanonisText text;
    text.version = "1";
    text.pixels = "2  3";
    EXPECT_EQ(readAsNanonis(text).channels.at(0).map.columns, 3);
}

TEST(NanonisReader, LowestByteFirstIsSaidInVain) {
    NanonisText text;
    text.type = "FLOAT            LSBFIRST";
    EXPECT_DOUBLE_EQ(readAsNanonis(text).channels.at(0).map.at(0, 0), 1.0);
    text.type = "INT MSBFIRST";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("SCANIT_TYPE: expected FLOAT"));
}

TEST(NanonisReader, TableMayHaveBlanksInPlaceOfTabs) {
    NanonisText text;
    text.table = "Channel Name Unit Direction Calibration Offset\n"
                 "   14   Z   nm   both   1.764E-8   0.000E+0\n";
    const ScanChannel channel = readAsNanonis(text).channels.at(0);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 1e-9);
}

TEST(NanonisReader, SignalsFollowTheTableAndItsDirections) {
    NanonisText text;
    text.table = "\tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n"
                 "\t14\tZ\tm\tforward\t1\t0\n\t0\tBias m\tV\tbackward\t1\t0\n";
    const HeightMapFile file = readAsNanonis(text);
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].name, "Z (Forward)");
    EXPECT_EQ(file.channels[1].name, "Bias m (Backward)");
    EXPECT_EQ(file.channels[1].unit, "V");
}

TEST(NanonisReader, FilesOfOtherToolsMayHoldOneImageASignal) {
    NanonisText text;
    text.time = "N/A";
    const std::vector<double> one = {1, 2, 3, 4, 5, 6};
    const HeightMapFile file = readAsNanonis(text, one);
    ASSERT_EQ(file.channels.size(), 1U);
    EXPECT_EQ(file.channels[0].name, "Z");
    EXPECT_EQ(file.channels[0].direction, "");
    EXPECT_THAT(file.notes, testing::Contains(HasSubstr("one image of each signal")));
    EXPECT_EQ(readAsNanonis(text).channels.size(), 2U);
    text.time = "131.3";
    const HeightMapFile cut = readAsNanonis(text, one);
    EXPECT_EQ(cut.channels.size(), 1U);
    EXPECT_THAT(cut.notes, testing::Contains(HasSubstr("not hold all of 'Z (Backward)'")));
}

TEST(NanonisReader, WholeImagesOfATruncatedFileOpenWithANote) {
    std::string bytes = nanonisFile({});
    bytes.resize(bytes.size() - 1);
    EXPECT_EQ(readHeightMapBytes(bytes, "scan.sxm").channels.size(), 1U);
    bytes.resize(bytes.size() - 24);
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes, "scan.sxm"); }),
                HasSubstr("truncated"));
}

TEST(NanonisReader, RotationOfTheScanIsNoted) {
    NanonisText text;
    EXPECT_TRUE(readAsNanonis(text).notes.empty());
    text.comment = "turned\n:SCAN_ANGLE:\n            -2.500E+1";
    EXPECT_THAT(readAsNanonis(text).notes,
                testing::ElementsAre(HasSubstr("rotated by -25 degrees")));
}

TEST(NanonisReader, ScanThatWasStoppedHasPixelsWithoutData) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const HeightMapFile stopped =
        readAsNanonis({}, {1, 2, 3, none, none, none, none, none, none, none, none, none});
    EXPECT_TRUE(std::isnan(stopped.channels.at(0).map.at(1, 0)));
    EXPECT_FALSE(std::isnan(stopped.channels.at(0).map.at(0, 0)));
    EXPECT_TRUE(std::isnan(stopped.channels.at(1).map.at(0, 0)));
}

TEST(NanonisReader, ConstantHeightIsAMap) {
    const HeightMapFile file = readAsNanonis({}, std::vector<double>(12, 3e-9F));
    EXPECT_DOUBLE_EQ(file.channels.at(0).map.at(1, 1), 3e-9F);
}

TEST(NanonisReader, RangeOfZeroIsUnknown) {
    NanonisText text;
    text.range = "0.0 0.0";
    EXPECT_FALSE(readAsNanonis(text).channels.at(0).hasSize());
}

TEST(NanonisReader, RefusesWhatDoesNotFit) {
    NanonisText text;
    text.pixels = "3.5 2";
    EXPECT_THAT(refusalOfNanonis(text),
                HasSubstr("scan.sxm: SCAN_PIXELS: expected two whole numbers"));
    text.pixels = "3";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("SCAN_PIXELS: expected two numbers"));
    text.pixels = "1e300 1e300";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("SCAN_PIXELS"));
    text.pixels = "60000 60000";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("truncated"));
    text = {};
    text.direction = "sideways";
    EXPECT_THAT(refusalOfNanonis(text),
                HasSubstr("SCAN_DIR: expected up or down, found 'sideways'"));
    text = {};
    text.mark = "data";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("1A 04"));
    text = {};
    text.table = "\tChannel\tName\tUnit\tDirection\n\t14\tZ\tm\tround\n";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("DATA_INFO: row 1: expected both"));
    text.table = "\tChannel\tName\tUnit\tDirection\n\t14\tZ\tm\n";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("row 1 is too short"));
    text.table = "\tChannel\tName\tUnit\n\t14\tZ\tm\n";
    EXPECT_THAT(refusalOfNanonis(text), HasSubstr("no column 'Direction'"));
}

}  // namespace asperity::test
