#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/TiffFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Park Systems TIFF: the header in a private tag, docs/formats.md 8.

namespace asperity::test {

namespace {

using testing::Contains;
using testing::HasSubstr;

/// A file of 3 x 2 counts of 1 to 6; tests change single values.
struct ParkTestFile {
    int version = 2;
    int imageType = 0;
    int columns = 3;
    int rows = 2;
    int forward = 1;
    int swapped = 0;
    double gain = -2.0;
    double scale = 0.5;
    double offset = 10.0;
    std::u16string unit = u"nm";
    int dataType = 2;
    std::size_t headerBytes = 580;
    double magic = 0x0E031301;
};

template <typename Number>
void putInHeader(std::string& header, std::size_t offset, Number value) {
    std::string bytes;
    appendLittleEndian(bytes, value);
    if (offset + bytes.size() <= header.size()) {
        header.replace(offset, bytes.size(), bytes);
    }
}

void putInHeader(std::string& header, std::size_t offset, const std::u16string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        putInHeader(header, offset + 2 * i, static_cast<std::uint16_t>(text[i]));
    }
}

std::string parkHeader(const ParkTestFile& file) {
    std::string header(file.headerBytes, '\0');
    putInHeader(header, 0, file.imageType);
    putInHeader(header, 4, std::u16string(u"Z Höhe"));
    putInHeader(header, 68, std::u16string(u"Tapping"));
    putInHeader(header, 100, file.columns);
    putInHeader(header, 104, file.rows);
    putInHeader(header, 128, file.forward);
    putInHeader(header, 136, file.swapped);
    putInHeader(header, 140, 3.0);
    putInHeader(header, 148, 4.0);
    putInHeader(header, 156, -7.0);
    putInHeader(header, 220, file.gain);
    putInHeader(header, 228, file.scale);
    putInHeader(header, 236, file.offset);
    putInHeader(header, 244, file.unit);
    putInHeader(header, 348, file.dataType);
    return header;
}

std::string parkFile(const ParkTestFile& file) {
    constexpr SampleType kTypes[] = {SampleType::Int16, SampleType::Int32, SampleType::Float32};
    const SampleType type =
        file.version == 1 ? SampleType::Int16 : kTypes[std::min(file.dataType, 2)];
    const TiffTestField samples{
        .tag = 50434, .type = 1, .bytes = sampleBytes({1, 2, 3, 4, 5, 6}, type, ByteOrder::Little)};
    const TiffTestField header{.tag = 50435, .type = 7, .bytes = parkHeader(file)};
    return tiffFile(
        {{.type = SampleType::UInt8,
          .photometric = 3,
          .extra = {tiffInteger(50432, file.magic), tiffInteger(50433, 0x01000000 + file.version),
                    samples, header, tiffText(50436, "as grown")}}});
}

HeightMapFile readAsPark(const ParkTestFile& file) {
    return readHeightMapBytes(parkFile(file), "small.tiff");
}
ScanChannel parkChannel(const ParkTestFile& file) { return readAsPark(file).channels.at(0); }
std::string refusalOfPark(const ParkTestFile& file) {
    return refusalOf([&] { (void)readAsPark(file); });
}

}  // namespace

TEST(ParkReader, ReadsTheHeaderAndTurnsTheImage) {
    const HeightMapFile file = readAsPark({});
    EXPECT_EQ(file.format, "Park Systems TIFF");
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.name, "Z Höhe");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.direction, "forward");
    EXPECT_EQ(channel.metadata.at("mode"), "Tapping");
    EXPECT_EQ(channel.metadata.at("comment"), "as grown");
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 1e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 2e-6);
    EXPECT_DOUBLE_EQ(channel.originX, -7e-6 - 1.5e-6);  // the offset is that of the center
    // -2 nm * (count * 0.5 + 10), the first stored row at the bottom.
    EXPECT_NEAR(channel.map.at(1, 0), -21e-9, 1e-20);
    EXPECT_NEAR(channel.map.at(0, 0), -24e-9, 1e-20);
    EXPECT_NEAR(channel.map.at(0, 2), -26e-9, 1e-20);
}

TEST(ParkReader, ReadsEveryTypeOfSamples) {
    for (const int type : {0, 1, 2}) {
        EXPECT_NEAR(parkChannel({.dataType = type}).map.at(0, 2), -26e-9, 1e-20) << type;
    }
    // Version 1 has a shorter header and 16-bit counts.
    EXPECT_NEAR(parkChannel({.version = 1, .headerBytes = 356}).map.at(0, 2), -26e-9, 1e-20);
    EXPECT_THAT(refusalOfPark({.dataType = 3}), HasSubstr("type 3"));
}

TEST(ParkReader, ScaleOfZeroIsOneAndNoUnitMicrometers) {
    const ScanChannel channel = parkChannel({.scale = 0.0, .offset = 0.0, .unit = u""});
    EXPECT_EQ(channel.unit, "m");
    EXPECT_NEAR(channel.map.at(0, 2), -12e-6, 1e-18);
    EXPECT_EQ(parkChannel({.unit = u"V"}).unit, "V");
}

TEST(ParkReader, DirectionAndExchangedAxesAreSaid) {
    const ScanChannel channel = parkChannel({.forward = 0, .swapped = 1});
    EXPECT_EQ(channel.direction, "backward");
    EXPECT_THAT(channel.notes, Contains(HasSubstr("x and y exchanged")));
}

TEST(ParkReader, RefusesWhatIsNoImageOrDoesNotFit) {
    EXPECT_THAT(refusalOfPark({.imageType = 2}), HasSubstr("force curves"));
    EXPECT_THAT(refusalOfPark({.imageType = 1}), HasSubstr("line profile"));
    EXPECT_THAT(refusalOfPark({.headerBytes = 356}), HasSubstr("expected 580"));
    EXPECT_THAT(refusalOfPark({.version = 3}), HasSubstr("version"));
    EXPECT_THAT(refusalOfPark({.magic = 1}), HasSubstr("tags of a Park file"));
    EXPECT_THAT(refusalOfPark({.columns = 4}), HasSubstr("expected 32 bytes"));
    EXPECT_THAT(refusalOfPark({.rows = 0}), HasSubstr("pixels"));
    EXPECT_THAT(refusalOfPark({.gain = 1e300}), HasSubstr("scale"));
}

}  // namespace asperity::test
