#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

HeightMapFile readAsNanosurf(const std::vector<NanosurfChannel>& channels) {
    return readHeightMapBytes(nanosurfFile(channels), "scan.nid");
}

std::string refusalOfNanosurf(const std::vector<NanosurfChannel>& channels) {
    return refusalOf([&] { (void)readAsNanosurf(channels); });
}

NanosurfChannel curves() {
    NanosurfChannel channel;
    channel.frame = "Spec forward";
    channel.points = "2";
    channel.lines = "4";
    channel.numbers = {9, 9, 9, 9, 9, 9, 9, 9};
    return channel;
}

}  // namespace

TEST(NanosurfReader, HeightsSpanTheRangeOfTheCounts) {
    const HeightMap map = readAsNanosurf({{}}).channels.at(0).map;
    EXPECT_DOUBLE_EQ(map.at(1, 0), -1e-6);
    EXPECT_DOUBLE_EQ(map.at(1, 1), 0.0);
    EXPECT_DOUBLE_EQ(map.at(0, 2), -1e-6 + 2e-6 * 65535 / 65536);
}

TEST(NanosurfReader, BackwardImageIsNotMirrored) {
    NanosurfChannel backward;
    backward.frame = "Scan backward";
    const HeightMapFile file = readAsNanosurf({{}, backward});
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].name, "Topography forward");
    EXPECT_EQ(file.channels[1].name, "Topography backward");
    EXPECT_EQ(file.channels[1].direction, "backward");
    EXPECT_DOUBLE_EQ(file.channels[1].map.at(1, 0), -1e-6);
}

TEST(NanosurfReader, ChannelSaysWhatTheHeaderSays) {
    const ScanChannel channel = readAsNanosurf({{}}).channels.at(0);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_EQ(channel.metadata.at("Image size"), "50\u00B5m");
}

TEST(NanosurfReader, SamplesHave8Or16Or32Bits) {
    NanosurfChannel narrow;
    narrow.bits = "8";
    narrow.stored = SampleType::Int8;
    narrow.numbers = {-128, 0, 0, 0, 0, 0};
    NanosurfChannel wide;
    wide.bits = "32";
    wide.stored = SampleType::Int32;
    wide.numbers = {-2147483648.0, 0, 0, 0, 0, 0};
    const HeightMapFile file = readAsNanosurf({narrow, wide});
    EXPECT_DOUBLE_EQ(file.channels.at(0).map.at(1, 0), -1e-6);
    EXPECT_DOUBLE_EQ(file.channels.at(1).map.at(1, 0), -1e-6);
    EXPECT_DOUBLE_EQ(file.channels.at(1).map.at(1, 1), 0.0);
    narrow.bits = "24";
    EXPECT_THAT(refusalOfNanosurf({narrow}),
                HasSubstr("SaveBits: expected 8, 16 or 32, found '24'"));
}

TEST(NanosurfReader, CurvesAreSkippedAndCounted) {
    NanosurfChannel image;
    image.numbers = {1, 2, 3, 4, 5, 6};
    const HeightMapFile file = readAsNanosurf({curves(), image});
    ASSERT_EQ(file.channels.size(), 1U);
    EXPECT_DOUBLE_EQ(file.channels[0].map.at(0, 2), -1e-6 + 2e-6 * (32768 + 6) / 65536);
    EXPECT_THAT(file.notes,
                Contains(AllOf(HasSubstr("force curves"), HasSubstr("'Spec forward' (4)"))));
}

TEST(NanosurfReader, FileOfCurvesOnlyIsNamedAsSuch) {
    EXPECT_THAT(
        refusalOfNanosurf({curves()}),
        AllOf(HasSubstr("scan.nid"), HasSubstr("force curves"), HasSubstr("'Spec forward' (4)")));
    NanosurfChannel line = curves();
    line.frame = "Scan forward";
    line.lines = "1";
    line.points = "8";
    EXPECT_THAT(refusalOfNanosurf({line}), HasSubstr("no image"));
}

TEST(NanosurfReader, LongCurvesAreNoLargeImage) {
    NanosurfChannel spectrum = curves();
    spectrum.points = "100000";
    spectrum.lines = "1";
    spectrum.numbers.assign(100000, 1.0);
    EXPECT_EQ(readAsNanosurf({spectrum, {}}).channels.size(), 1U);
    spectrum.points = "16777216";
    spectrum.lines = "16777216";
    EXPECT_THAT(refusalOfNanosurf({spectrum, {}}), HasSubstr("truncated"));
    spectrum.lines = "-1";
    EXPECT_THAT(refusalOfNanosurf({spectrum, {}}), HasSubstr("Points, Lines"));
}

TEST(NanosurfReader, WholeImagesOfATruncatedFileOpenWithANote) {
    const std::string bytes = nanosurfFile({{}, {}});
    const HeightMapFile cut =
        readHeightMapBytes(std::string_view(bytes).substr(0, bytes.size() - 1), "cut.nid");
    EXPECT_EQ(cut.channels.size(), 1U);
    EXPECT_THAT(cut.notes, testing::Contains(HasSubstr("truncated")));
}

TEST(NanosurfReader, SizeOfZeroIsUnknown) {
    NanosurfChannel channel;
    channel.sizeX = "0";
    EXPECT_FALSE(readAsNanosurf({channel}).channels.at(0).hasSize());
}

TEST(NanosurfReader, RefusesWhatDoesNotFit) {
    NanosurfChannel channel;
    channel.range = "inf";
    EXPECT_THAT(refusalOfNanosurf({channel}), HasSubstr("[DataSet-0:1] Dim2Min, Dim2Range"));
    channel = {};
    channel.order = "Motorola";
    EXPECT_THAT(refusalOfNanosurf({channel}),
                HasSubstr("SaveOrder: expected Intel, found 'Motorola'"));
    channel = {};
    channel.points = "4";
    EXPECT_THAT(refusalOfNanosurf({channel}), HasSubstr("truncated"));
    channel.points = "0";
    EXPECT_THAT(refusalOfNanosurf({channel}), HasSubstr("0 x 2 pixels"));
    channel.points = "many";
    EXPECT_THAT(refusalOfNanosurf({channel}),
                HasSubstr("Points: expected a whole number, found 'many'"));
    EXPECT_THAT(refusalOfNanosurf({}), HasSubstr("lists no image"));
}

TEST(NanosurfReader, HeaderThatALineEndDamagedIsNamedAsSuch) {
    EXPECT_THAT(refusalOf([] { (void)readHeightMapBytes("[DataSet]\nVersion=2\n#!", "scan.nid"); }),
                HasSubstr("damaged"));
    const std::string lost = "[DataSet]\r\nGr0-Ch0=DataSet-0:0\r\n#!";
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(lost, "scan.nid"); }),
                HasSubstr("no section [DataSet-0:0]"));
}

}  // namespace asperity::test
