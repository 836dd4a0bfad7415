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

ScanChannel wsxmChannel(const WsxmText& text,
                        const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6}) {
    return readHeightMapBytes(wsxmFile(text, numbers), "scan.stp").channels.at(0);
}

std::string refusalOfWsxm(const WsxmText& text) {
    return refusalOf([&] { (void)wsxmChannel(text); });
}

}  // namespace

TEST(WsxmReader, RowsAndColumnsAreStoredInReverse) {
    const ScanChannel channel = wsxmChannel({});
    EXPECT_EQ(channel.name, "Topography");
    EXPECT_EQ(channel.direction, "backward");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 6 * 2e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 2), 4 * 2e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 1 * 2e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_DOUBLE_EQ(channel.originX, -712.919e-9 - 15e-9);  // the offset is that of the center
}

TEST(WsxmReader, ReadsEveryTypeOfSamples) {
    const struct {
        const char* line;
        SampleType type;
    } types[] = {{"", SampleType::Int16},
                 {"    Image Data Type: short\r\n", SampleType::Int16},
                 {"    Image Data Type: integer\r\n", SampleType::Int32},
                 {"    Image Data Type: float\r\n", SampleType::Float32},
                 {"    Image Data Type: double\r\n", SampleType::Float64}};
    for (const auto& type : types) {
        SCOPED_TRACE(type.line);
        WsxmText text;
        text.typeLine = type.line;
        text.stored = type.type;
        EXPECT_DOUBLE_EQ(wsxmChannel(text).map.at(0, 0), 6 * 2e-9);
    }
    WsxmText text;
    text.typeLine = "    Image Data Type: quad\r\n";
    EXPECT_THAT(refusalOfWsxm(text),
                HasSubstr("scan.stp: [General Info] Image Data Type: expected short, integer"));
}

TEST(WsxmReader, MicroSignMayBeLatin) {
    WsxmText text;
    text.amplitudeX = "2 \xB5m";
    text.amplitudeZ = "2 \xB5m";
    const ScanChannel channel = wsxmChannel(text);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 2e-6);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 6 * 0.4e-6);
}

TEST(WsxmReader, AnAmplitudeInAIsInAngstromsButForACurrent) {
    WsxmText text;
    text.amplitudeX = "600 A";
    text.amplitudeZ = "10 A";
    const ScanChannel height = wsxmChannel(text);
    EXPECT_EQ(height.unit, "m");
    EXPECT_DOUBLE_EQ(height.map.sizeX(), 600e-10);
    EXPECT_DOUBLE_EQ(height.map.at(0, 0), 6 * 2e-10);
    std::string current = wsxmFile(text, {1, 2, 3, 4, 5, 6});
    current.replace(current.find("Topography"), 10, "Current   ");
    EXPECT_EQ(readHeightMapBytes(current, "scan.stp").channels.at(0).unit, "A");
}

TEST(WsxmReader, FlatImageIsZero) {
    const ScanChannel channel = wsxmChannel({}, std::vector<double>(6, 5.0));
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.map.at(0, 0), 0.0);
    EXPECT_EQ(channel.map.at(1, 2), 0.0);
}

TEST(WsxmReader, NumbersThatAreNoneHoldNoDataAndNoRange) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const HeightMap map = wsxmChannel({}, {1, none, 3, 4, 5, 6}).map;
    EXPECT_TRUE(std::isnan(map.at(1, 1)));
    EXPECT_DOUBLE_EQ(map.at(0, 0), 6 * 2e-9);
    EXPECT_TRUE(std::isnan(wsxmChannel({}, std::vector<double>(6, none)).map.at(0, 0)));
}

TEST(WsxmReader, WhatTheFileDoesNotSayIsUnknown) {
    WsxmText text;
    text.amplitudeX = "";
    text.amplitudeZ = "0 nm";
    const ScanChannel channel = wsxmChannel(text);
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.unit, "");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 6.0);
    text.amplitudeZ = "10 a.u.";
    EXPECT_EQ(wsxmChannel(text).unit, "");
    text.amplitudeZ = "10 V";
    EXPECT_EQ(wsxmChannel(text).unit, "V");
}

TEST(WsxmReader, VersionIsKept) {
    std::string bytes = wsxmFile({});
    bytes.insert(bytes.find("[Header end]"),
                 "[Miscellaneous]\r\n\r\n    Version: 5.0 Develop 9.1 (August 2018)\r\n\r\n");
    const HeightMapFile file = readHeightMapBytes(bytes, "scan.stp");
    ASSERT_EQ(file.provenance.size(), 1U);
    EXPECT_EQ(file.provenance.front().value, "5.0 Develop 9.1 (August 2018)");
}

TEST(WsxmReader, CurvesAreNamedAsSuch) {
    WsxmText text;
    text.kind = "Force Curve file";
    EXPECT_THAT(refusalOfWsxm(text), HasSubstr("this WSxM file holds curves, no image"));
    text.kind = "SxM Movie file";
    EXPECT_THAT(refusalOfWsxm(text), HasSubstr("line 2: expected 'SxM Image file'"));
}

TEST(WsxmReader, RefusesWhatDoesNotFit) {
    std::string bytes = wsxmFile({});
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes.substr(0, 200), "scan.stp"); }),
                HasSubstr("no '[Header end]'"));
    bytes[bytes.find("[Header end]") + 12] = 'x';
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(bytes, "scan.stp"); }),
                HasSubstr("line end"));
    WsxmText text;
    text.typeLine += "    Number of columns: 60000\r\n";
    EXPECT_THAT(refusalOfWsxm(text), HasSubstr("truncated"));
}

}  // namespace asperity::test
