#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <png.h>

// Height maps in PNG: 16-bit gray with Gwyddion's texts; docs/formats.md 9.

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// A PNG of 4 x 3 pixels; tests change single values.
struct PngTestFile {
    int bits = 16;
    int color = PNG_COLOR_TYPE_GRAY;
    int interlace = PNG_INTERLACE_NONE;
    std::map<std::string, std::string> texts;
    bool textsBehind = false;  ///< the pixels
};
constexpr int kPngColumns = 4;
constexpr int kPngRows = 3;

/// Samples of a row: 1000 per row and 1 per column.
std::vector<png_byte> pngRow(const PngTestFile& file, int row) {
    const bool hasAlpha = (file.color & PNG_COLOR_MASK_ALPHA) != 0;
    const int channels =
        ((file.color & PNG_COLOR_MASK_COLOR) != 0 && (file.color & PNG_COLOR_MASK_PALETTE) == 0
             ? 3
             : 1) +
        (hasAlpha ? 1 : 0);
    std::vector<png_byte> bytes;
    for (int column = 0; column < kPngColumns; ++column) {
        for (int channel = 0; channel < channels; ++channel) {
            const bool isAlpha = hasAlpha && channel == channels - 1;
            const int sample = isAlpha ? 7 : 1000 * row + column;
            if (file.bits == 16) {
                bytes.push_back(static_cast<png_byte>(sample / 256));
            }
            bytes.push_back(static_cast<png_byte>(file.bits == 16 ? sample % 256 : row % 2));
        }
    }
    return bytes;
}

void setTexts(png_structp png, png_infop info, const PngTestFile& file) {
    for (const auto& [key, value] : file.texts) {
        std::string keyCopy = key;
        std::string valueCopy = value;
        png_text text{};
        text.compression =
            key == "Gwy::Title" ? PNG_ITXT_COMPRESSION_NONE : PNG_TEXT_COMPRESSION_NONE;
        text.key = keyCopy.data();
        text.text = valueCopy.data();
        png_set_text(png, info, &text, 1);
    }
}

std::string pngFile(const PngTestFile& file) {
    const ScratchFolder folder;
    std::FILE* const stream = std::fopen(folder.file("small.png").c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream);
    png_set_IHDR(png, info, kPngColumns, kPngRows, file.bits, file.color, file.interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const png_color palette[2] = {{0, 0, 0}, {255, 200, 0}};
    if (file.color == PNG_COLOR_TYPE_PALETTE) {
        png_set_PLTE(png, info, palette, 2);
    }
    if (!file.textsBehind) {
        setTexts(png, info, file);
    }
    png_write_info(png, info);
    std::vector<std::vector<png_byte>> rows;
    std::vector<png_bytep> starts;
    for (int row = 0; row < kPngRows; ++row) {
        rows.push_back(pngRow(file, row));
        starts.push_back(rows.back().data());
    }
    png_write_image(png, starts.data());
    if (file.textsBehind) {
        setTexts(png, info, file);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    (void)std::fclose(stream);
    return contentOf(folder.file("small.png"));
}

HeightMapFile readAsPng(const std::string& bytes) { return readHeightMapBytes(bytes, "small.png"); }
ScanChannel pngChannel(const PngTestFile& file) { return readAsPng(pngFile(file)).channels.at(0); }
std::string refusalOfPng(const std::string& bytes) {
    return refusalOf([&] { (void)readAsPng(bytes); });
}

const std::map<std::string, std::string> kTexts = {
    {"Gwy::XReal", "4e-6"}, {"Gwy::YReal", "6e-6"},    {"Gwy::XYUnit", "m"},
    {"Gwy::ZMin", "-1e-7"}, {"Gwy::ZMax", "5.535e-6"}, {"Gwy::ZUnit", "m"},
    {"Gwy::Title", "Höhe"}, {"Comment", "as grown"}};

}  // namespace

TEST(PngReader, GwyddionsTextsAreTheScale) {
    for (const bool behind : {false, true}) {
        const ScanChannel channel = pngChannel({.texts = kTexts, .textsBehind = behind});
        EXPECT_EQ(channel.name, "Höhe");
        EXPECT_EQ(channel.unit, "m");
        EXPECT_EQ(channel.metadata.at("Comment"), "as grown");
        EXPECT_DOUBLE_EQ(channel.map.pitchX, 1e-6);
        EXPECT_DOUBLE_EQ(channel.map.pitchY, 2e-6);
        const double step = 5.635e-6 / 65535.0;
        EXPECT_NEAR(channel.map.at(0, 0), -1e-7, 1e-18);
        EXPECT_NEAR(channel.map.at(2, 3), -1e-7 + 2003 * step, 1e-18);
    }
}

TEST(PngReader, WithoutTextsValuesAreNumbersFromTheTop) {
    const ScanChannel channel = pngChannel({});
    EXPECT_EQ(channel.name, "gray");
    EXPECT_EQ(channel.unit, "");
    EXPECT_FALSE(channel.hasSize());
    EXPECT_EQ(channel.map.at(0, 1), 1.0);
    EXPECT_EQ(channel.map.at(2, 0), 2000.0);
    EXPECT_THAT(channel.notes, Contains(HasSubstr("they are numbers")));
}

TEST(PngReader, InterlacedAndTransparentGrayIsTheSame) {
    const std::vector<double> heights = pngChannel({}).map.heights;
    EXPECT_EQ(pngChannel({.interlace = PNG_INTERLACE_ADAM7}).map.heights, heights);
    const ScanChannel transparent = pngChannel({.color = PNG_COLOR_TYPE_GRAY_ALPHA});
    EXPECT_EQ(transparent.map.heights, heights);
    EXPECT_THAT(transparent.notes, Contains(HasSubstr("transparency")));
}

TEST(PngReader, PicturesAreRefusedInWords) {
    EXPECT_THAT(refusalOfPng(pngFile({.bits = 8})), HasSubstr("a picture of 8-bit gray"));
    EXPECT_THAT(refusalOfPng(pngFile({.bits = 8, .color = PNG_COLOR_TYPE_PALETTE})),
                HasSubstr("palette"));
    EXPECT_THAT(refusalOfPng(pngFile({.color = PNG_COLOR_TYPE_RGB})), HasSubstr("a color picture"));
    EXPECT_THAT(refusalOfPng(pngFile({.color = PNG_COLOR_TYPE_RGB_ALPHA})),
                HasSubstr("a color picture"));
}

/// Colors of a screen are no heights, whatever the user says of them.
TEST(PngReader, PicturesAreRefusedWhateverScaleIsGiven) {
    const ScratchFolder folder;
    for (const PngTestFile& picture :
         {PngTestFile{.bits = 8}, PngTestFile{.bits = 8, .color = PNG_COLOR_TYPE_PALETTE},
          PngTestFile{.color = PNG_COLOR_TYPE_RGB}}) {
        const auto path = folder.write("picture.png", pngFile(picture));
        EXPECT_THAT(refusalOf([&] {
                        ScanFile(path, {1e-6, 1e-6, 1e-9}, {});
                    }),
                    HasSubstr("picture"));
    }
}

TEST(PngReader, AFalseNumberIsRefusedByItsKey) {
    EXPECT_THAT(refusalOfPng(pngFile({.texts = {{"Gwy::YReal", "wide"}}})),
                HasSubstr("Gwy::YReal"));
    EXPECT_THAT(refusalOfPng(pngFile({.texts = {{"Gwy::ZMin", "nan"}, {"Gwy::ZMax", "1"}}})),
                HasSubstr("scale"));
}

TEST(PngReader, EveryBitIsUnderAChecksum) {
    const std::string bytes = pngFile({.texts = kTexts});
    for (std::size_t offset = 8; offset < bytes.size(); ++offset) {
        std::string damaged = bytes;
        damaged[offset] = static_cast<char>(damaged[offset] ^ 0x10);
        EXPECT_THROW((void)readAsPng(damaged), InputError) << offset;
        EXPECT_THROW((void)readAsPng(bytes.substr(0, offset)), InputError) << offset;
    }
}

TEST(PngReader, RefusesMorePixelsThanItsDataCanHold) {
    std::string bytes = pngFile({});
    bytes.replace(16, 8, std::string("\0\0\x80\0\0\0\x80\0", 8));
    EXPECT_THAT(refusalOfPng(bytes), HasSubstr("cannot hold 32768 x 32768"));
    bytes.replace(16, 4, std::string("\0\1\0\1", 4));
    EXPECT_THAT(refusalOfPng(bytes), HasSubstr("65537 x 32768 pixels"));
}

/// 2 MB of equal pixels took 16 s and 2 GB.
TEST(PngReader, RefusesABillionEqualPixels) {
    std::string bytes = pngFile({});
    bytes.replace(16, 8, std::string("\0\0\x80\0\0\0\x80\0", 8));
    bytes.insert(bytes.size() - 12, std::string("\0\x1E\x84\x80IDAT", 8) +
                                        std::string(2'000'000 + 4, 'x'));  // and a checksum
    EXPECT_THAT(refusalOfPng(bytes), AllOf(HasSubstr("its images decode to 2.15 GB"),
                                           HasSubstr("of 2 MB at most 1.07 GB are expected")));
}

}  // namespace asperity::test
