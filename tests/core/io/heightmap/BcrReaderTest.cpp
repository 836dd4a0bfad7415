#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;

constexpr std::size_t kBcrHeaderSize = 2048;

ScanChannel bcrChannel(const std::string& bytes) {
    return readHeightMapBytes(bytes, "map.bcr").channels.at(0);
}

std::string refusalOfBcr(const std::string& bytes) {
    return refusalOf([&] { (void)readHeightMapBytes(bytes, "map.bcr"); });
}

std::string bcrHeader(const std::string& lines, const std::string& format = "bcrstm") {
    std::string header = "fileformat = " + format +
                         "\nxpixels = 3\nypixels = 2\nxlength = 30\nylength = 40\n" + lines;
    header.resize(kBcrHeaderSize, ' ');
    return header;
}

const std::vector<std::int16_t> kCounts = {1, 2, 3, 4, 32767, 6};

/// A file of 3 x 2 counts.
std::string int16File(const std::string& lines) {
    std::string bytes = bcrHeader(lines);
    for (const std::int16_t count : kCounts) {
        appendLittleEndian(bytes, count);
    }
    return bytes;
}

std::string floatFile(const std::string& lines) {
    std::string bytes = bcrHeader(lines, "bcrf");
    for (const float number : {1.F, 2.F, 3.F, 4.F, 3.4e38F, 6.F}) {
        appendLittleEndian(bytes, number);
    }
    return bytes;
}

}  // namespace

TEST(BcrReader, CountsAreNanometersPerBit) {
    const ScanChannel channel = bcrChannel(int16File("bit2nm = 0.5 # per bit\nintelmode = 1\n"));
    EXPECT_EQ(channel.name, "Topography");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 2), 1.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 2e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 40e-9);
}

TEST(BcrReader, TheHighestNumberMeansNoDataWhateverTheHeaderSays) {
    const std::vector<bool> invalid = {false, false, false, false, true, false};
    EXPECT_EQ(bcrChannel(int16File("bit2nm = 1\nvoidpixels = 0\n")).map.invalid, invalid);
    EXPECT_EQ(bcrChannel(floatFile("")).map.invalid, invalid);
}

TEST(BcrReader, OfSeveralFieldsTheLastOneCounts) {
    const ScanChannel channel = bcrChannel(int16File("bit2nm = 1\nxlength = 5000\nbit2nm = 2\n"));
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 5e-6);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 2e-9);
}

TEST(BcrReader, UnitsMayBeNamed) {
    const ScanChannel channel =
        bcrChannel(int16File("bit2nm = 0.5\nzunit = um\nxunit = \xB5m\nyunit = nm\nxoffset = 2\n"));
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-6);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-6);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 40e-9);
    EXPECT_DOUBLE_EQ(channel.originX, 2e-6);
    EXPECT_EQ(bcrChannel(floatFile("zunit = V\n")).unit, "V");
}

TEST(BcrReader, PositiveMinimumLiftsTheHeights) {
    const HeightMap counts = bcrChannel(int16File("bit2nm = 0.5\nzmin = 5\n")).map;
    EXPECT_DOUBLE_EQ(counts.at(0, 0), 5e-9);
    EXPECT_DOUBLE_EQ(counts.at(1, 2), 7.5e-9);
    const HeightMap floats = bcrChannel(floatFile("bit2nm = 2\nzmin = 10\n")).map;
    EXPECT_DOUBLE_EQ(floats.at(0, 0), 10e-9);
    EXPECT_DOUBLE_EQ(floats.at(1, 2), 15e-9);
    EXPECT_DOUBLE_EQ(bcrChannel(floatFile("zmin = -5\n")).map.at(0, 0), 1e-9);
}

TEST(BcrReader, ByteOrderIsThatOfTheHeader) {
    const HeightMap map = bcrChannel(int16File("bit2nm = 1\nintelmode = 0\n")).map;
    EXPECT_DOUBLE_EQ(map.at(0, 0), 256e-9);
    EXPECT_TRUE(map.invalid.empty());
}

TEST(BcrReader, CountsWithoutAScaleAreNoHeights) {
    const ScanChannel channel = bcrChannel(int16File("zmin = 5\n"));
    EXPECT_EQ(channel.unit, "");
    EXPECT_EQ(channel.map.at(0, 1), 2.0);
}

TEST(BcrReader, SidesInDifferentUnitsGiveNoSize) {
    const ScanChannel channel = bcrChannel(int16File("bit2nm = 1\nxunit = nm\nyunit = s\n"));
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.map.pitchX, 0.0);
}

TEST(BcrReader, HeaderMayBeUtf16OrOfAnotherSize) {
    const std::string narrow = int16File("bit2nm = 0.5\nxunit = \xB5m\r\n");
    std::string wide;
    for (const char c : narrow.substr(0, kBcrHeaderSize)) {
        wide += {c, '\0'};
    }
    EXPECT_DOUBLE_EQ(bcrChannel(wide + narrow.substr(kBcrHeaderSize)).map.sizeX(), 30e-6);
    const std::string sized = int16File("bit2nm = 0.5\nheadersize = 1000\n");
    EXPECT_DOUBLE_EQ(bcrChannel(sized.substr(0, 1000) + sized.substr(kBcrHeaderSize)).map.at(0, 1),
                     1e-9);
}

TEST(BcrReader, RefusesWhatItCannotRead) {
    const std::string whole = int16File("bit2nm = 1\n");
    EXPECT_THAT(refusalOfBcr(whole.substr(0, whole.size() - 1)), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfBcr(whole.substr(0, 30)), HasSubstr("xpixels"));
    EXPECT_THAT(refusalOfBcr(int16File("forcecurve = 1\n")), HasSubstr("force curve"));
    EXPECT_THAT(refusalOfBcr(int16File("bit2nm = many\n")), HasSubstr("bit2nm: expected a number"));
    EXPECT_THAT(refusalOfBcr(int16File("headersize = -1\n")), HasSubstr("headersize"));
    EXPECT_THAT(refusalOfBcr(int16File("headersize = 1000000\n")), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfBcr(bcrHeader("", "bcrxyz")), HasSubstr("bcrxyz"));
    EXPECT_THAT(refusalOfBcr(int16File("xpixels = 70000\n")), HasSubstr("70000 x 2"));
    EXPECT_EQ(bcrChannel(whole + "anything").map.rows, 2);
}

}  // namespace asperity::test
