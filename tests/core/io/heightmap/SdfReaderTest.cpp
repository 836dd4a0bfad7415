#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

ScanChannel sdfChannel(const std::string& bytes) {
    return readHeightMapBytes(bytes, "map.sdf").channels.at(0);
}

std::string refusalOfSdf(const std::string& bytes) {
    return refusalOf([&] { (void)readHeightMapBytes(bytes, "map.sdf"); });
}

/// A text file of 3 x 2 points. @param numbers with all that follows
std::string textFile(const std::string& numbers = "1 2 3\n4 5 6\n*\n",
                     const std::string& zScale = "1e-9") {
    return "aISO-1.0\nManufacID   = MAN\nNumPoints   = 3 ; columns\nNumProfiles = 2\n"
           "Xscale      = 1e-6\nYscale      = 2e-6\nZscale      = " +
           zScale + "\nCompression = 0\nDataType    = 7\nCheckType   = 0\n*\n" + numbers;
}

/// The header of a binary file of 3 x 2 points.
std::string binaryHeader(std::uint8_t type, std::uint8_t compression = 0,
                         std::uint16_t columns = 3) {
    std::string bytes = "bISO-1.0";
    bytes += std::string("MAN").append(7, '\0') + "010120201200" + "010120201200";
    appendLittleEndian(bytes, columns);
    appendLittleEndian(bytes, std::uint16_t{2});
    for (const double number : {1e-6, 2e-6, 1e-9, 1e-12}) {
        appendLittleEndian(bytes, number);
    }
    for (const std::uint8_t number : {compression, type, std::uint8_t{0}}) {
        appendLittleEndian(bytes, number);
    }
    EXPECT_EQ(bytes.size(), 81U);
    return bytes;
}

template <typename Number>
std::string binaryFile(std::uint8_t type, const std::vector<double>& numbers) {
    std::string bytes = binaryHeader(type);
    for (const double number : numbers) {
        appendLittleEndian(bytes, static_cast<Number>(number));
    }
    return bytes;
}

}  // namespace

TEST(SdfReader, TextHasItsFirstRowOnTop) {
    const ScanChannel channel = sdfChannel(textFile());
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 2), 3e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 4e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 3e-6);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 4e-6);
    EXPECT_EQ(channel.metadata.at("NumPoints"), "3");
}

TEST(SdfReader, LinesOfNumbersMayBreakAnywhere) {
    EXPECT_DOUBLE_EQ(sdfChannel(textFile("1 2\n3 4 5\n\n6 *\n trailer")).map.at(1, 2), 6e-9);
    EXPECT_DOUBLE_EQ(sdfChannel(textFile("1 2 3 4 5 6\r\n*\r\n")).map.at(1, 2), 6e-9);
}

TEST(SdfReader, BadMeansNoData) {
    const HeightMap map = sdfChannel(textFile("1 BAD 3\n4 5 6\n*\n")).map;
    EXPECT_TRUE(map.invalid.at(1));
    EXPECT_FALSE(map.invalid.at(2));
}

TEST(SdfReader, CountsOfNumbersMustFit) {
    EXPECT_THAT(refusalOfSdf(textFile("1 2 3\n4 5\n*\n")),
                HasSubstr("expected 6 numbers, found 5"));
    EXPECT_THAT(refusalOfSdf(textFile("1 2 3\n4 5 6 7\n*\n")), HasSubstr("more than 6"));
    EXPECT_THAT(refusalOfSdf(textFile("1 2 3\n4 5 6\n")),
                AllOf(HasSubstr("map.sdf: line "), HasSubstr("truncated")));
    EXPECT_THAT(refusalOfSdf(textFile("1 2 x\n4 5 6\n*\n")), HasSubstr("'x'"));
}

TEST(SdfReader, WithoutAScaleTheNumbersAreNoHeights) {
    for (const char* scale : {"0", "nan"}) {
        const ScanChannel channel = sdfChannel(textFile("1 2 3\n4 5 6\n*\n", scale));
        EXPECT_EQ(channel.unit, "");
        EXPECT_EQ(channel.map.at(0, 0), 1.0);
    }
    EXPECT_THAT(refusalOfSdf(textFile("1 2 3\n4 5 6\n*\n", "")), HasSubstr("Zscale"));
}

TEST(SdfReader, EveryTypeOfSampleIsRead) {
    const std::vector<double> numbers = {1, 2, 3, 4, 5, 100};
    for (const std::string& bytes :
         {binaryFile<std::uint8_t>(0, numbers), binaryFile<std::uint16_t>(1, numbers),
          binaryFile<std::uint32_t>(2, numbers), binaryFile<float>(3, numbers),
          binaryFile<std::int8_t>(4, numbers), binaryFile<std::int16_t>(5, numbers),
          binaryFile<std::int32_t>(6, numbers), binaryFile<double>(7, numbers)}) {
        const HeightMap map = sdfChannel(bytes).map;
        EXPECT_TRUE(map.invalid.empty());
        EXPECT_DOUBLE_EQ(map.at(0, 0), 1e-9);
        EXPECT_DOUBLE_EQ(map.at(1, 2), 100e-9);
        EXPECT_DOUBLE_EQ(map.sizeY(), 4e-6);
    }
}

TEST(SdfReader, TheLowestCountMeansNoData) {
    for (const std::string& bytes : {binaryFile<std::int16_t>(5, {1, 2, 3, -32768, 5, 6}),
                                     binaryFile<std::int32_t>(6, {1, 2, 3, -2147483648.0, 5, 6}),
                                     binaryFile<std::uint16_t>(1, {1, 2, 3, 65535, 5, 6}),
                                     binaryFile<double>(7, {1, 2, 3, kNan, 5, 6})}) {
        EXPECT_EQ(sdfChannel(bytes).map.invalid,
                  std::vector<bool>({false, false, false, true, false, false}));
    }
}

TEST(SdfReader, RefusesWhatItCannotRead) {
    const std::string whole = binaryFile<std::int16_t>(5, {1, 2, 3, 4, 5, 6});
    EXPECT_THAT(refusalOfSdf(whole.substr(0, whole.size() - 1)), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfSdf(whole.substr(0, 60)), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfSdf(binaryHeader(8) + std::string(48, '\0')), HasSubstr("DataType"));
    EXPECT_THAT(refusalOfSdf(binaryHeader(5, 1) + std::string(12, '\0')), HasSubstr("Compression"));
    EXPECT_THAT(refusalOfSdf(binaryHeader(5, 0, 0)), HasSubstr("0 x 2 pixels"));
    EXPECT_THAT(refusalOfSdf(binaryHeader(7, 0, 60000)), HasSubstr("truncated"));
    EXPECT_EQ(sdfChannel(whole + "anything").map.rows, 2);
}

}  // namespace asperity::test
