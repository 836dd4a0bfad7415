#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ImageScale.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;

/// An export of 3 x 2 pixels, 300 nm x 200 nm; tests change single parts.
struct AnalysisText {
    std::string scanList = "\"\\Scan Size: 300 nm\"\n\"\\Samps/line: 3\"\n\"\\Lines: 2\"\n"
                           "\"\\Aspect Ratio: 1:1\"\n\"\\X Offset: 1000 nm\"\n";
    std::string imageList = "\"\\Samps/line: 3\"\n\"\\Number of lines: 2\"\n"
                            "\"\\Scan Size: 300 200 nm\"\n\"\\Line Direction: Retrace\"\n";
    std::string titles = "Height_Sensor(nm)\tPeak_Force_Error(nN)\n";
    std::string values = "1.5\t10\n2\t20\n3\t30\n4\t40\n5\t50\n6\t60\n";
};

std::string analysisFile(const AnalysisText& text) {
    return "\"\\*File list\"\n\"\\Version: 0x09400103\"\n\"\\*Ciao scan list\"\n" + text.scanList +
           "\"\\*Ciao image list\"\n" + text.imageList + "\"\\*File list end\"\n" + text.titles +
           text.values;
}

HeightMapFile readAnalysis(const std::string& bytes) {
    return readHeightMapBytes(bytes, "export.txt");
}

std::string refusalOfAnalysis(const std::string& bytes) {
    return refusalOf([&] { (void)readAnalysis(bytes); });
}

}  // namespace

TEST(NanoscopeText, EachColumnIsAChannelFromTheTop) {
    const HeightMapFile file = readAnalysis(analysisFile({}));
    EXPECT_EQ(file.format, "NanoScope Analysis text");
    ASSERT_EQ(file.channels.size(), 2U);
    const ScanChannel& height = file.channels[file.defaultChannel];
    EXPECT_EQ(height.name, "Height_Sensor");
    EXPECT_EQ(height.unit, "m");
    EXPECT_EQ(height.direction, "backward");
    EXPECT_EQ(height.map.columns, 3);
    EXPECT_EQ(height.map.rows, 2);
    EXPECT_DOUBLE_EQ(height.map.at(0, 0), 1.5e-9);
    EXPECT_DOUBLE_EQ(height.map.at(1, 2), 6e-9);
    EXPECT_DOUBLE_EQ(height.map.sizeX(), 300e-9);
    EXPECT_DOUBLE_EQ(height.map.sizeY(), 200e-9);
    EXPECT_DOUBLE_EQ(height.originX, 850e-9);
    EXPECT_EQ(height.metadata.at("Version"), "0x09400103");
    EXPECT_EQ(file.channels[1].name, "Peak_Force_Error");
    EXPECT_EQ(file.channels[1].unit, "N");
    EXPECT_DOUBLE_EQ(file.channels[1].map.at(1, 0), 40e-9);
}

TEST(NanoscopeText, LineEndsAndDecimalCommasMayBeThoseOfOtherSystems) {
    AnalysisText text;
    text.titles = "Height(\xB5m)\n";
    text.values = "1,5\n2,25\n3,125\n4\n5\n6\n";
    text.imageList = "\"\\Samps/line: 3\"\n\"\\Number of lines: 2\"\n"
                     "\"\\Scan Size: 300,5 200,25 nm\"\n";
    std::string bytes = analysisFile(text);
    for (std::size_t at = bytes.find('\n'); at != std::string::npos;
         at = bytes.find('\n', at + 2)) {
        bytes.insert(at, 1, '\r');
    }
    const ScanChannel channel = readAnalysis(bytes).channels.at(0);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 2), 3.125e-6);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 300.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 200.25e-9);
}

TEST(NanoscopeText, WithoutAHeaderASquareIsTakenAndItsSizeIsAskedFor) {
    const HeightMapFile file = readAnalysis("Height_Sensor(nm)\tPhase(Deg)\r\n"
                                            "1.0\t5\r\n2.0\t6\r\n3.0\t7\r\n4.0\t8\r\n");
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].map.columns, 2);
    EXPECT_DOUBLE_EQ(file.channels[0].map.at(1, 0), 3e-9);
    EXPECT_EQ(file.channels[1].unit, "deg");
    EXPECT_FALSE(file.channels[0].hasSize());
    EXPECT_THAT(file.channels[0].notes, testing::Contains(HasSubstr("taken as a square")));
    EXPECT_THROW((void)heightChannel(file, "export.txt", ""), MissingScale);
    EXPECT_THAT(refusalOfAnalysis("Height_Sensor(nm)\n1\n2\n3\n4\n5\n6\n"),
                HasSubstr("6 values a channel may have any shape"));
}

TEST(NanoscopeText, PointsStayPoints) {
    EXPECT_EQ(readAnalysis("X(nm)\tY(nm)\tZ(nm)\n0\t0\t1\n1\t0\t2\n0\t1\t3\n1\t1\t4\n").format,
              "XYZ points");
}

TEST(NanoscopeText, RefusesWhatDoesNotFit) {
    AnalysisText text;
    text.values = "1\t2\n3\t4\n5\t6\n7\t8\n";
    EXPECT_THAT(refusalOfAnalysis(analysisFile(text)), HasSubstr("promises 3 x 2 values"));
    text.values = "1\t2\n3\n";
    EXPECT_THAT(refusalOfAnalysis(analysisFile(text)), HasSubstr("found 1 numbers"));
    text.values = "1\tnonsense\n";
    EXPECT_THAT(refusalOfAnalysis(analysisFile(text)), HasSubstr("found 'nonsense'"));
    text.titles = "no unit here\n";
    EXPECT_THAT(refusalOfAnalysis(analysisFile(text)), HasSubstr("titles with units"));
    EXPECT_THAT(refusalOfAnalysis("\"\\*File list\"\n"), HasSubstr("titles with units"));
    EXPECT_THAT(refusalOfAnalysis("\"\\*File list\"\nHeight(nm)\n1\n"),
                HasSubstr("lists no image"));
}

TEST(NanoscopeText, ScanThatWasStoppedHasItsFirstLines) {
    AnalysisText text;
    text.values = "1\t2\n3\t4\n5\t6\n";
    const ScanChannel channel = readAnalysis(analysisFile(text)).channels.at(0);
    EXPECT_EQ(channel.map.rows, 1);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 100e-9);
}

}  // namespace asperity::test
