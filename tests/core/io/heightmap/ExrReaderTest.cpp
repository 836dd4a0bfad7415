#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

// Height maps in OpenEXR: floats, half floats and counts with Gwyddion's attributes;
// docs/formats.md 9.

namespace asperity::test {

namespace {

using testing::Contains;
using testing::HasSubstr;

/// A file of 5 x 3 pixels whose data window begins at (-2, 7); tests change single values.
struct ExrTestFile {
    std::vector<std::string> channels = {"Y"};
    Imf::PixelType type = Imf::FLOAT;
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    Imf::LineOrder order = Imf::INCREASING_Y;
    bool isTiled = false;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};
constexpr int kExrColumns = 5;
constexpr int kExrRows = 3;
constexpr double kHole = 7.0;  ///< pixel that is NaN

/// Pixel of a channel: a number that half floats hold.
float sampleOf(std::size_t channel, int pixel) {
    return pixel == static_cast<int>(kHole) && channel == 0
               ? std::numeric_limits<float>::quiet_NaN()
               : static_cast<float>(channel * 100) + static_cast<float>(pixel) * 0.5F;
}

template <typename Output>
void writePixels(Output& output, const Imf::FrameBuffer& frame);
template <>
void writePixels(Imf::OutputFile& output, const Imf::FrameBuffer& frame) {
    output.setFrameBuffer(frame);
    output.writePixels(kExrRows);
}
template <>
void writePixels(Imf::TiledOutputFile& output, const Imf::FrameBuffer& frame) {
    output.setFrameBuffer(frame);
    output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
}

Imf::Header exrHeader(const ExrTestFile& file) {
    const Imath::Box2i window({-2, 7}, {2, 9});
    Imf::Header header(window, window);
    header.compression() = file.compression;
    header.lineOrder() = file.order;
    for (const std::string& name : file.channels) {
        header.channels().insert(name, Imf::Channel(file.type));
    }
    for (const auto& [key, value] : file.numbers) {
        header.insert(key, Imf::DoubleAttribute(value));
    }
    for (const auto& [key, value] : file.texts) {
        header.insert(key, Imf::StringAttribute(value));
    }
    if (file.isTiled) {
        header.setTileDescription(Imf::TileDescription(16, 16));
    }
    return header;
}

template <typename Sample>
std::string writeExr(const ExrTestFile& file) {
    std::vector<std::vector<Sample>> planes(file.channels.size());
    Imf::FrameBuffer frame;
    const Imf::Header header = exrHeader(file);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (int pixel = 0; pixel < kExrColumns * kExrRows; ++pixel) {
            const float sample = sampleOf(i, pixel);
            if constexpr (std::is_same_v<Sample, unsigned>) {
                planes[i].push_back(std::isnan(sample) ? 0U : static_cast<unsigned>(2 * sample));
            } else {
                planes[i].push_back(Sample(sample));
            }
        }
        frame.insert(file.channels[i],
                     Imf::Slice::Make(file.type, planes[i].data(), header.dataWindow()));
    }
    const ScratchFolder folder;
    const std::filesystem::path path = folder.file("small.exr");
    if (file.isTiled) {
        Imf::TiledOutputFile output(path.c_str(), header);
        writePixels(output, frame);
    } else {
        Imf::OutputFile output(path.c_str(), header);
        writePixels(output, frame);
    }
    return contentOf(path);
}

std::string exrFile(const ExrTestFile& file) {
    if (file.type == Imf::HALF) {
        return writeExr<half>(file);
    }
    return file.type == Imf::UINT ? writeExr<unsigned>(file) : writeExr<float>(file);
}

HeightMapFile readAsExr(const std::string& bytes) { return readHeightMapBytes(bytes, "small.exr"); }
ScanChannel exrChannel(const ExrTestFile& file) { return readAsExr(exrFile(file)).channels.at(0); }
std::string refusalOfExr(const std::string& bytes) {
    return refusalOf([&] { (void)readAsExr(bytes); });
}

void expectSamples(const HeightMap& map, double factor) {
    ASSERT_EQ(map.columns, kExrColumns);
    ASSERT_EQ(map.rows, kExrRows);
    for (int pixel = 0; pixel < kExrColumns * kExrRows; ++pixel) {
        const double height = map.heights[static_cast<std::size_t>(pixel)];
        const double expected = static_cast<double>(sampleOf(0, pixel)) * factor;
        EXPECT_TRUE(height == expected || (std::isnan(height) && std::isnan(expected))) << pixel;
    }
    EXPECT_EQ(std::ranges::count(map.invalid, true), 1);
}

}  // namespace

TEST(ExrReader, ReadsFloatsAndHalfFloatsInEveryOrder) {
    for (const Imf::PixelType type : {Imf::FLOAT, Imf::HALF}) {
        for (const Imf::Compression compression :
             {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
              Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
            expectSamples(exrChannel({.type = type, .compression = compression}).map, 1.0);
        }
        expectSamples(exrChannel({.type = type, .order = Imf::DECREASING_Y}).map, 1.0);
        expectSamples(exrChannel({.type = type, .isTiled = true}).map, 1.0);
    }
}

TEST(ExrReader, GwyddionsAttributesAreTheScale) {
    const ScanChannel channel =
        exrChannel({.type = Imf::HALF,
                    .numbers = {{"Gwy::XReal", 5.0}, {"Gwy::YReal", 6.0}, {"Gwy::ZScale", 1e-9}},
                    .texts = {{"Gwy::XYUnit", "um"}, {"Gwy::ZUnit", "m"}, {"Gwy::Title", "Höhe"}}});
    EXPECT_EQ(channel.name, "Höhe");
    EXPECT_EQ(channel.unit, "m");
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 1e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 2e-6);
    expectSamples(channel.map, 1e-9);
    EXPECT_TRUE(channel.notes.empty());
}

TEST(ExrReader, HalfFloatsOfMetersAreCalledCoarse) {
    const ScanChannel channel = exrChannel({.type = Imf::HALF, .texts = {{"Gwy::ZUnit", "m"}}});
    EXPECT_THAT(channel.notes, Contains(HasSubstr("too coarse")));
}

TEST(ExrReader, CountsHaveTheirEnds) {
    const ScanChannel plain = exrChannel({.type = Imf::UINT});
    EXPECT_EQ(plain.map.at(1, 0), 5.0);
    EXPECT_EQ(plain.unit, "");
    const ScanChannel scaled =
        exrChannel({.type = Imf::UINT,
                    .numbers = {{"Gwy::ZMin", 1.0}, {"Gwy::ZMax", 4294967296.0}},
                    .texts = {{"Gwy::ZUnit", "nm"}}});
    EXPECT_NEAR(scaled.map.at(1, 0), 6e-9, 1e-17);
}

TEST(ExrReader, EveryChannelOfNumbersIsOne) {
    const HeightMapFile file =
        readAsExr(exrFile({.channels = {"A", "Y", "phase"}, .texts = {{"Gwy::ZUnit", "m"}}}));
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].name, "Y");
    EXPECT_EQ(file.channels[0].unit, "m");
    EXPECT_EQ(file.channels[1].name, "phase");
    EXPECT_EQ(file.channels[1].unit, "");
    EXPECT_EQ(file.channels[1].map.at(0, 1), 200.5);
}

TEST(ExrReader, PicturesAreRefusedInWords) {
    EXPECT_THAT(refusalOfExr(exrFile({.channels = {"B", "G", "R"}})), HasSubstr("a color picture"));
    EXPECT_EQ(readAsExr(exrFile({.channels = {"B", "G", "R", "Z"}})).channels.at(0).name, "Z");
}

/// As if another program had cut it while it was read, it was said.
TEST(ExrReader, ATruncatedFileIsToldWhereItEnds) {
    const ScratchFolder folder;
    const std::string bytes = exrFile({});
    const std::filesystem::path file = folder.write("cut.exr", bytes.substr(0, bytes.size() - 4));
    EXPECT_THAT(
        refusalOf([&] { (void)readHeightMapFile(file); }),
        HasSubstr("cut.exr: byte " + std::to_string(bytes.size() - 4) + ": the content ends here"));
}

TEST(ExrReader, EveryTruncationIsRefused) {
    const std::string bytes =
        exrFile({.numbers = {{"Gwy::XReal", 5.0}}, .texts = {{"Gwy::Title", "Height"}}});
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        EXPECT_THROW((void)readAsExr(bytes.substr(0, length)), InputError) << length;
    }
}

TEST(ExrReader, EveryBitMayFlip) {
    for (const bool isTiled : {false, true}) {
        const std::string bytes = exrFile({.isTiled = isTiled, .texts = {{"Gwy::ZUnit", "m"}}});
        for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
            std::string damaged = bytes;
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
            try {
                (void)readAsExr(damaged);
            } catch (const InputError&) {
            }
        }
    }
}

TEST(ExrReader, RefusesMorePixelsThanTheFileCanHold) {
    std::string bytes = exrFile({});
    const std::size_t window = bytes.find("dataWindow") + 11 + 6 + 4;
    bytes.replace(window + 8, 8, std::string("\xF0\x7F\0\0\xF0\x7F\0\0", 8));
    EXPECT_THAT(refusalOfExr(bytes), HasSubstr("cannot hold"));
    bytes.replace(window + 8, 8, std::string("\xFF\xFF\xFF\x7F\xFF\xFF\xFF\x7F", 8));
    EXPECT_THAT(refusalOfExr(bytes), HasSubstr("pixels"));
}

TEST(ExrReader, RefusesFarMoreBytesThanTheyArePackedIn) {
    std::string bytes = exrFile({});
    const std::size_t window = bytes.find("dataWindow") + 11 + 6 + 4;
    bytes.replace(window, 16, std::string("\0\0\0\0\0\0\0\0\xFF\x7F\0\0\xFF\x7F\0\0", 16));
    EXPECT_THAT(refusalOfExr(bytes + std::string(1'000'000, 'x')),
                HasSubstr("its images decode to 4.29 GB or more"));
}

TEST(ExrReader, RefusesAnAttributeThatTheLibraryWouldReadAtAnotherLength) {
    std::string bytes = exrFile({.texts = {{"Gwy::Title", "Height"}}});
    bytes.replace(bytes.find("string", bytes.find("Gwy::Title")), 6, "double");
    EXPECT_THAT(refusalOfExr(bytes), HasSubstr("'Gwy::Title' is not as long as a double"));
    std::string channels = exrFile({});
    channels[channels.find("chlist") + 7] ^= 1;  // its size
    EXPECT_THAT(refusalOfExr(channels), HasSubstr("not as long as a chlist"));
}

/// Each would carry a copy of all texts.
TEST(ExrReader, MoreChannelsThanAnInstrumentWritesAreRefused) {
    ExrTestFile file;
    file.channels.clear();
    for (int i = 0; i < 129; ++i) {
        file.channels.push_back("c" + std::to_string(i));
    }
    EXPECT_THAT(refusalOf([&] { (void)readHeightMapBytes(exrFile(file), "many.exr"); }),
                HasSubstr("many.exr: channels: at most 128 images are expected, found 129"));
}

}  // namespace asperity::test
