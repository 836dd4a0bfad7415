#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;

HeightMapFile readAsPicoview(const PicoviewText& text, SampleType stored = SampleType::Int32,
                             const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6}) {
    return readHeightMapBytes(picoviewFile(text, stored, numbers), "scan.mi");
}

std::string refusalOfPicoview(const PicoviewText& text) {
    return refusalOf([&] { (void)readAsPicoview(text); });
}

}  // namespace

TEST(PicoviewReader, FirstStoredRowIsTheBottomOfTheImage) {
    const ScanChannel channel = readAsPicoview({}).channels.at(0);
    EXPECT_EQ(channel.name, "Topography");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.direction, "forward");
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_DOUBLE_EQ(channel.originX, 1e-9 - 15e-9);  // the offset is that of the center
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 4 * 2e-6 / 2147483648.0);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 3 * 2e-6 / 2147483648.0);
    EXPECT_EQ(channel.metadata.at("version"), "PicoView 0x10c04");
}

TEST(PicoviewReader, SamplesHave16BitsWhereTheHeaderNamesNoWidth) {
    PicoviewText text;
    for (const char* kind : {"BINARY", ""}) {
        text.data = kind;
        EXPECT_DOUBLE_EQ(readAsPicoview(text, SampleType::Int16).channels.at(0).map.at(1, 0),
                         2e-6 / 32768.0);
    }
}

TEST(PicoviewReader, ImagesFollowEachOther) {
    PicoviewText text;
    text.image += "bufferLabel   Friction\nbufferRange   1.0e+001\nbufferUnit    V\n"
                  "trace         Retrace\n";
    const HeightMapFile file =
        readAsPicoview(text, SampleType::Int32, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[1].unit, "V");
    EXPECT_EQ(file.channels[1].direction, "backward");
    EXPECT_DOUBLE_EQ(file.channels[1].map.at(1, 0), 70.0 / 2147483648.0);
}

TEST(PicoviewReader, SizeThatIsNotGivenIsUnknown) {
    PicoviewText text;
    text.size.clear();
    const ScanChannel channel = readAsPicoview(text).channels.at(0);
    EXPECT_FALSE(channel.hasSize());
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("no lateral size")));
}

TEST(PicoviewReader, ValuesWithoutARangeAreNumbers) {
    PicoviewText text;
    text.image = "bufferLabel   Topography\nbufferUnit    um\n";
    const ScanChannel channel = readAsPicoview(text).channels.at(0);
    EXPECT_EQ(channel.unit, "");
    EXPECT_DOUBLE_EQ(channel.map.at(1, 0), 1.0);
}

TEST(PicoviewReader, CurvesAreNamedAsSuch) {
    PicoviewText text;
    text.firstLine = "fileType      Spectroscopy\n";
    EXPECT_THAT(refusalOfPicoview(text),
                HasSubstr("scan.mi: this PicoView file holds force curves or spectra, no image"));
}

TEST(PicoviewReader, RefusesWhatDoesNotFit) {
    PicoviewText text;
    text.data = "ASCII";
    EXPECT_THAT(refusalOfPicoview(text), HasSubstr("save it with binary data"));
    text.data = "BINARY_64";
    EXPECT_THAT(refusalOfPicoview(text), HasSubstr("found 'BINARY_64'"));
    text = {};
    text.firstLine = "fileType      Image\r\n";
    EXPECT_THAT(refusalOfPicoview(text), HasSubstr("damaged"));
    text = {};
    text.image = "bufferLabel   Topography\nbufferRange   wide\n";
    EXPECT_THAT(refusalOfPicoview(text),
                HasSubstr("image 1 bufferRange: expected a number, found 'wide'"));
    text.image.clear();
    EXPECT_THAT(refusalOfPicoview(text), HasSubstr("lists no image"));
    text = {};
    text.image += "bufferLabel   Friction\n";
    const std::string cut = picoviewFile(text, SampleType::Int32);
    const HeightMapFile file = readHeightMapBytes(cut, "cut.mi");
    EXPECT_EQ(file.channels.size(), 1U);
    EXPECT_THAT(file.notes, testing::Contains(HasSubstr("not hold all of 'Friction'")));
    EXPECT_THAT(
        refusalOf([&] { (void)readHeightMapBytes(cut.substr(0, cut.size() - 1), "cut.mi"); }),
        HasSubstr("image 'Topography': its data end at byte"));
}

}  // namespace asperity::test
