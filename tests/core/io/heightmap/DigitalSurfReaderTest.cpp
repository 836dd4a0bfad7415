#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <zlib.h>

// The files are made from the layout alone (docs/formats.md 15): no real one has proven it.

namespace asperity::test {

namespace {

using testing::HasSubstr;

HeightMapFile readAsDigitalSurf(const DigitalSurfText& text,
                                const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6}) {
    return readHeightMapBytes(digitalSurfFile(text, numbers), "surface.sur");
}

std::string refusalOfDigitalSurf(const DigitalSurfText& text) {
    return refusalOf([&] { (void)readAsDigitalSurf(text); });
}

/// Offsets behind header, comment and private zone [bytes].
constexpr std::size_t kStreamCount = 512 + 5 + 3;
constexpr std::size_t kFirstStreamSize = kStreamCount + 4;

/// A file whose samples are packed into this many streams.
std::string compressedSurf(const std::vector<double>& numbers, std::size_t streams = 1) {
    DigitalSurfText text;
    text.magic = "DSCOMPRESSED";
    std::string bytes = digitalSurfFile(text, numbers);
    const std::string samples = bytes.substr(kStreamCount);
    bytes.resize(kStreamCount);
    appendLittleEndian(bytes, static_cast<std::uint32_t>(streams));
    const std::size_t part = samples.size() / streams;
    std::string packed;
    for (std::size_t i = 0; i < streams; ++i) {
        uLongf size = compressBound(part);
        std::string stream(size, '\0');
        compress(reinterpret_cast<Bytef*>(stream.data()), &size,
                 reinterpret_cast<const Bytef*>(samples.data() + i * part), part);
        packed += stream.substr(0, size);
        appendLittleEndian(bytes, static_cast<std::uint32_t>(part));
        appendLittleEndian(bytes, static_cast<std::uint32_t>(size));
    }
    return bytes + packed;
}

std::string refusalOfBytes(const std::string& bytes) {
    return refusalOf([&] { (void)readHeightMapBytes(bytes, "packed.sur"); });
}

}  // namespace

TEST(DigitalSurfReader, FirstStoredRowIsTheTopOfTheImage) {
    const HeightMapFile file = readAsDigitalSurf({});
    const ScanChannel& channel = file.channels.at(0);
    EXPECT_EQ(channel.name, "Height");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 3e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeX(), 30e-9);
    EXPECT_DOUBLE_EQ(channel.map.sizeY(), 20e-9);
    EXPECT_EQ(channel.metadata.at("object name"), "steps");
    EXPECT_THAT(file.notes, testing::Contains(HasSubstr("no real .sur file")));
}

TEST(DigitalSurfReader, OffsetIsInTheUnitOfTheStep) {
    DigitalSurfText text;
    text.unit = "\xB5m";
    text.offset = 2.0F;
    EXPECT_DOUBLE_EQ(readAsDigitalSurf(text).channels.at(0).map.at(0, 0), 2.5e-6);
}

TEST(DigitalSurfReader, SamplesMayHave32Bits) {
    DigitalSurfText text;
    text.bits = 32;
    text.stored = SampleType::Int32;
    EXPECT_DOUBLE_EQ(readAsDigitalSurf(text, {100000, 2, 3, 4, 5, 6}).channels.at(0).map.at(0, 0),
                     50e-6);
    text.bits = 24;
    EXPECT_THAT(refusalOfDigitalSurf(text),
                HasSubstr("surface.sur: byte 98: expected samples of 16 or 32"));
}

TEST(DigitalSurfReader, SpecialPointsAreNoData) {
    DigitalSurfText text;
    text.lowest = 3;
    EXPECT_FALSE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 0)));
    text.specialPoints = 1;
    EXPECT_TRUE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 0)));
    EXPECT_FALSE(std::isnan(readAsDigitalSurf(text).channels.at(0).map.at(0, 1)));
}

TEST(DigitalSurfReader, InvertedSurfaceIsShownAsItIsStored) {
    DigitalSurfText text;
    text.inversion = 1;
    const ScanChannel channel = readAsDigitalSurf(text).channels.at(0);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-9);
    EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("inverted")));
}

TEST(DigitalSurfReader, HeaderAndFileSizeMustAgree) {
    DigitalSurfText text;
    text.commentSize = 4;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("bytes 334 to 337"));
    text.commentSize = 6;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("truncated"));
}

TEST(DigitalSurfReader, AnOffsetThatIsNoNumberIsRefused) {
    DigitalSurfText text;
    text.offset = std::numeric_limits<float>::infinity();
    EXPECT_THAT(refusalOfDigitalSurf(text),
                HasSubstr("expected a step and an offset of the heights"));
}

TEST(DigitalSurfReader, CompressedSamplesAreUnpacked) {
    const ScanChannel channel =
        readHeightMapBytes(compressedSurf({1, 2, 3, 4, 5, 6}), "packed.sur").channels.at(0);
    EXPECT_DOUBLE_EQ(channel.map.at(0, 0), 0.5e-9);
    EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 3e-9);
    const ScanChannel parts =
        readHeightMapBytes(compressedSurf({1, 2, 3, 4, 5, 6}, 2), "packed.sur").channels.at(0);
    EXPECT_EQ(parts.map.heights, channel.map.heights);
}

TEST(DigitalSurfReader, DamagedCompressedSamplesAreRefused) {
    const std::string bytes = compressedSurf({1, 2, 3, 4, 5, 6});
    EXPECT_THAT(refusalOfBytes(bytes.substr(0, bytes.size() - 1)), HasSubstr("truncated"));
    EXPECT_THAT(refusalOfBytes(bytes.substr(0, 520)), HasSubstr("packed.sur"));
    std::string damaged = bytes;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    EXPECT_THAT(refusalOfBytes(damaged), HasSubstr("cannot be unpacked"));
    damaged = bytes;
    damaged[kFirstStreamSize] = 13;
    EXPECT_THAT(refusalOfBytes(damaged), HasSubstr("hold 13 bytes"));
    damaged = bytes;
    damaged[kStreamCount + 3] = 1;
    EXPECT_THAT(refusalOfBytes(damaged), HasSubstr("1 to 65536 compressed streams"));
}

TEST(DigitalSurfReader, OtherObjectsOfOneLayerAreSurfaces) {
    DigitalSurfText text;
    for (const int object : {1, 3, 10, 99}) {
        text.object = object;
        const ScanChannel channel = readAsDigitalSurf(text).channels.at(0);
        EXPECT_DOUBLE_EQ(channel.map.at(1, 2), 3e-9) << object;
        EXPECT_THAT(channel.notes, testing::Contains(HasSubstr("object of type")));
    }
    text.rows = 1;
    text.object = 1;
    EXPECT_THAT(refusalOf([&] {
                    (void)readAsDigitalSurf(text, {1, 2, 3});
                }),
                HasSubstr("a profile, no surface"));
    text.object = 14;
    EXPECT_THAT(refusalOfDigitalSurf(text), HasSubstr("force curves, no image"));
}

TEST(DigitalSurfReader, SeveralObjectsAreSeveralChannels) {
    const std::string one = digitalSurfFile({});
    const HeightMapFile file = readHeightMapBytes(one + one, "two.sur");
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[1].name, "Height 2");
    EXPECT_EQ(file.channels[1].map.heights, file.channels[0].map.heights);
    const HeightMapFile cut =
        readHeightMapBytes((one + one).substr(0, 2 * one.size() - 1), "cut.sur");
    EXPECT_EQ(cut.channels.size(), 1U);
    EXPECT_THAT(cut.notes, testing::Contains(HasSubstr("truncated")));
}

}  // namespace asperity::test
