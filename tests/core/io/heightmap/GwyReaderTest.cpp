#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

HeightMapFile readAsGwy(const std::string& bytes) { return readHeightMapBytes(bytes, "scan.gwy"); }

std::string refusalOfGwy(const std::string& bytes) {
    return refusalOf([&] { (void)readAsGwy(bytes); });
}

std::string field(const std::string& components) {
    return gwyFile(gwyComponent("/0/data", gwyObjectBytes("GwyDataField", components)));
}

std::string sizeOf(std::int32_t columns, std::int32_t rows) {
    return gwyInteger("xres", columns) + gwyInteger("yres", rows);
}

}  // namespace

TEST(GwyReader, RowsComeFromTheTopAndColumnsFromTheLeft) {
    const HeightMap map =
        readAsGwy(gwyFile(gwyComponent("/0/data", smallGwyField()))).channels.at(0).map;
    EXPECT_EQ(map.columns, 2);
    EXPECT_EQ(map.rows, 3);
    EXPECT_DOUBLE_EQ(map.pitchX, 2e-9);
    EXPECT_DOUBLE_EQ(map.pitchY, 3e-9);
    EXPECT_EQ(map.at(0, 1), 2e-9);
    EXPECT_EQ(map.at(2, 0), 5e-9);
}

TEST(GwyReader, ImagesAreNumberedFromAnywhereWithGapsInAnyOrder) {
    const HeightMapFile file = readAsGwy(
        gwyFile(gwyText("/12/data/title", "late") + gwyComponent("/12/data", smallGwyField()) +
                gwyComponent("/3/data", smallGwyField()) + gwyText("/3/data/title", "early") +
                gwyText("/7/data/title", "a title alone is no image")));
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].name, "early");
    EXPECT_EQ(file.channels[1].name, "late");
}

TEST(GwyReader, MaskedPixelsAreInvalid) {
    const std::string mask =
        gwyObjectBytes("GwyDataField", sizeOf(2, 3) + gwyNumbers("data", {0, 1, 0, 0, 0.5, -1}));
    const HeightMapFile file = readAsGwy(
        gwyFile(gwyComponent("/0/mask", mask) + gwyComponent("/0/data", smallGwyField())));
    const HeightMap& map = file.channels.at(0).map;
    EXPECT_EQ(map.invalid, (PixelMask{0, 1, 0, 0, 1, 0}));
    EXPECT_TRUE(std::isnan(map.at(0, 1)));
    EXPECT_EQ(map.at(0, 0), 1e-9);
    EXPECT_THAT(file.channels.at(0).notes.at(0), HasSubstr("2 pixels"));
}

/// A scene on one image named the masks of all.
TEST(GwyReader, AMaskIsNotedOnItsOwnImageAlone) {
    const std::string mask =
        gwyObjectBytes("GwyDataField", sizeOf(2, 3) + gwyNumbers("data", {0, 1, 0, 0, 1, 1}));
    const ScratchFolder folder;
    const auto path = folder.write(
        "two.gwy",
        gwyFile(gwyComponent("/0/data", smallGwyField()) + gwyText("/0/data/title", "Height") +
                gwyComponent("/1/data", smallGwyField()) + gwyText("/1/data/title", "Masked") +
                gwyComponent("/1/mask", mask)));
    EXPECT_THAT(heightChannels(readHeightMapFile(path)), ElementsAre("Height", "Masked"));
    EXPECT_THAT(readHeightScan(path, "Height").notes, IsEmpty());
    EXPECT_THAT(readHeightChannel(path, "Height").notes, IsEmpty());
    EXPECT_THAT(readHeightScan(path, "Masked").notes,
                ElementsAre("'Masked': 3 pixels marked by the file's mask are taken as invalid"));
}

TEST(GwyReader, NanAndInfinityAreInvalid) {
    const HeightMap map =
        readAsGwy(field(sizeOf(3, 1) + gwyNumbers("data", {std::nan(""), 1, kInfinity})))
            .channels.at(0)
            .map;
    EXPECT_EQ(map.invalid, (PixelMask{1, 0, 1}));
    EXPECT_TRUE(std::isnan(map.heights[2]));
}

TEST(GwyReader, SkipsWhatItDoesNotKnow) {
    std::string nested = gwyText("deep", "end");
    for (int depth = 0; depth < 1000; ++depth) {
        nested = gwyComponent("in", gwyObjectBytes("GwyUnknown", nested));
    }
    const std::string strings =
        std::string("tags") + '\0' + "S" + std::string("\2\0\0\0", 4) + std::string("a\0b\0", 4);
    const HeightMapFile file =
        readAsGwy(gwyFile(nested + strings + gwyComponent("/0/data", smallGwyField()) +
                          gwyInteger("/0/base/range-type", 2)));
    EXPECT_EQ(file.channels.size(), 1U);
}

TEST(GwyReader, KeepsMetadataOffsetsAndUnits) {
    const std::string image = gwyObjectBytes(
        "GwyDataField", sizeOf(1, 1) + gwyNumber("xreal", 2.0) + gwyNumber("yreal", 3.0) +
                            gwyNumber("xoff", -5.0) + gwyUnit("si_unit_xy", "um") +
                            gwyUnit("si_unit_z", "N/m") + gwyNumbers("data", {7}));
    const std::string meta = gwyObjectBytes("GwyContainer", gwyText("Probe", "silicon \xB5"));
    const ScanChannel channel =
        readAsGwy(gwyFile(gwyComponent("/1/data", image) + gwyComponent("/1/meta", meta)))
            .channels.at(0);
    EXPECT_EQ(channel.unit, "N/m");
    EXPECT_DOUBLE_EQ(channel.originX, -5e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 3e-6);
    EXPECT_EQ(channel.metadata.at("Probe"), "silicon µ");
}

TEST(GwyReader, UnknownSizeIsNotOneMeter) {
    for (const double size : {0.0, -1.0, std::nan("")}) {
        const HeightMapFile file =
            readAsGwy(field(sizeOf(1, 1) + gwyNumber("xreal", size) + gwyUnit("si_unit_z", "m") +
                            gwyNumbers("data", {1})));
        EXPECT_EQ(file.channels.at(0).map.pitchX, 0.0);
        EXPECT_THROW((void)heightChannel(file, "scan.gwy", ""), InputError);
    }
}

TEST(GwyReader, RefusesDamagedStructures) {
    EXPECT_THAT(refusalOfGwy("GWYO"), HasSubstr("Gwyddion 1"));
    EXPECT_THAT(refusalOfGwy("GWYP"), HasSubstr("byte 4"));
    EXPECT_THAT(refusalOfGwy("GWYP" + gwyObjectBytes("GwyDataField", "")),
                HasSubstr("GwyContainer"));
    EXPECT_THAT(refusalOfGwy(gwyFile("")), HasSubstr("no image"));
    EXPECT_THAT(refusalOfGwy(gwyFile(std::string("key\0z1", 6))), HasSubstr("unknown type"));
    EXPECT_THAT(refusalOfGwy(gwyFile(std::string("key\0Z\1\0\0\0", 9))), HasSubstr("unknown type"));
    EXPECT_THAT(refusalOfGwy(gwyFile(std::string("key\0D\xFF\xFF\xFF\xFF", 9))),
                HasSubstr("array"));
    EXPECT_THAT(refusalOfGwy(gwyFile(std::string("key\0o", 5) + std::string("C\0\xFF\0\0\0", 6))),
                HasSubstr("expected 255 bytes"));
    EXPECT_THAT(refusalOfGwy(gwyFile(gwyText("/0/data", "text"))), HasSubstr("expected 'o'"));
}

TEST(GwyReader, RefusesFieldsThatDoNotFitTogether) {
    const std::string one = gwyNumbers("data", {1});
    EXPECT_THAT(refusalOfGwy(field(sizeOf(2, 1) + one)), HasSubstr("2 x 1 pixels are promised"));
    EXPECT_THAT(refusalOfGwy(field(sizeOf(0, 1) + one)), HasSubstr("0 x 1 pixels"));
    EXPECT_THAT(refusalOfGwy(field(sizeOf(-1, -1) + one)), HasSubstr("-1 x -1 pixels"));
    EXPECT_THAT(refusalOfGwy(field(sizeOf(70000, 70000) + one)), HasSubstr("65536"));
    EXPECT_THAT(refusalOfGwy(field(sizeOf(65536, 65536) + one)), HasSubstr("promised"));
    EXPECT_THAT(refusalOfGwy(field(gwyNumber("xres", 1.0) + one)), HasSubstr("expected 'i'"));
    const std::string mask =
        gwyObjectBytes("GwyDataField", sizeOf(3, 2) + gwyNumbers("data", {0, 0, 0, 0, 0, 0}));
    EXPECT_THAT(refusalOfGwy(gwyFile(gwyComponent("/0/mask", mask) +
                                     gwyComponent("/0/data", smallGwyField()))),
                HasSubstr("mask"));
}

TEST(GwyReader, TrailingBytesAreIgnoredAndNoted) {
    const HeightMapFile file =
        readAsGwy(gwyFile(gwyComponent("/0/data", smallGwyField())) + "tail");
    EXPECT_THAT(file.notes.at(0), HasSubstr("4 bytes"));
}

TEST(GwyReader, WholeImagesOfATruncatedFileOpenWithANote) {
    const std::string first = gwyComponent("/0/data", smallGwyField());
    const std::string bytes = gwyFile(first + gwyComponent("/1/data", smallGwyField()));
    const HeightMapFile cut =
        readHeightMapBytes(std::string_view(bytes).substr(0, bytes.size() - 1), "cut.gwy");
    EXPECT_EQ(cut.channels.size(), 1U);
    EXPECT_THAT(cut.notes, testing::Contains(testing::HasSubstr("'/1/data'")));
    EXPECT_THROW((void)readHeightMapBytes(
                     std::string_view(bytes).substr(0, bytes.size() - first.size() - 1), "cut.gwy"),
                 InputError);
}

TEST(GwyReader, ImageWhoseMaskIsCutIsNotWhole) {
    const std::string bytes = gwyFile(gwyComponent("/0/data", smallGwyField()) +
                                      gwyComponent("/1/data", smallGwyField()) +
                                      gwyComponent("/0/mask", smallGwyField()));
    const HeightMapFile cut =
        readHeightMapBytes(std::string_view(bytes).substr(0, bytes.size() - 1), "cut.gwy");
    ASSERT_EQ(cut.channels.size(), 1U);
    EXPECT_EQ(cut.channels[0].name, "Image 1");
}

}  // namespace asperity::test
