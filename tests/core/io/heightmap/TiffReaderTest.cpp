#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/TiffFiles.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <tiffio.h>

// Height maps in TIFF of any program: byte orders, types, strips, tiles, compression, scale.

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

HeightMapFile readAsTiff(const std::string& bytes) {
    return readHeightMapBytes(bytes, "small.tif");
}
ScanChannel tiffChannel(const TiffTestImage& image) {
    return readAsTiff(tiffFile({image})).channels.at(0);
}
std::string refusalOfTiff(const std::string& bytes) {
    return refusalOf([&] { (void)readAsTiff(bytes); });
}
std::string refusalOfTiff(const TiffTestImage& image) { return refusalOfTiff(tiffFile({image})); }

/// A TIFF of 37 x 21 pixels as the TIFF library writes it.
struct PackedTiff {
    std::uint16_t compression = COMPRESSION_LZW;
    std::uint16_t predictor = PREDICTOR_NONE;
    bool isTiled = false;
    bool isFloat = true;
    const char* mode = "w";
};
constexpr int kTiffColumns = 37;
constexpr int kTiffRows = 21;

double heightOf(int row, int column) { return 100.0 * row + column + 0.5; }

template <typename Sample>
std::vector<Sample> samplesOf(int firstRow, int firstColumn, int rows, int columns) {
    std::vector<Sample> samples;
    for (int row = firstRow; row < firstRow + rows; ++row) {
        for (int column = firstColumn; column < firstColumn + columns; ++column) {
            samples.push_back(static_cast<Sample>(heightOf(row, column)));
        }
    }
    return samples;
}

template <typename Sample>
void writePixels(TIFF* tiff, bool isTiled) {
    constexpr int kTile = 16;
    constexpr int kRowsPerStrip = 8;
    if (isTiled) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kTile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, kTile);
        for (int row = 0; row < kTiffRows; row += kTile) {
            for (int column = 0; column < kTiffColumns; column += kTile) {
                std::vector<Sample> tile = samplesOf<Sample>(row, column, kTile, kTile);
                TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(column),
                              static_cast<std::uint32_t>(row), 0, 0);
            }
        }
        return;
    }
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kRowsPerStrip);
    for (int row = 0; row < kTiffRows; ++row) {
        std::vector<Sample> line = samplesOf<Sample>(row, 0, 1, kTiffColumns);
        TIFFWriteScanline(tiff, line.data(), static_cast<std::uint32_t>(row), 0);
    }
}

std::string packedTiff(const PackedTiff& packed) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.file("packed.tif");
    TIFF* const tiff = TIFFOpen(path.c_str(), packed.mode);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kTiffColumns);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kTiffRows);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, packed.isFloat ? 32 : 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
                 packed.isFloat ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, packed.compression);
    if (packed.predictor != PREDICTOR_NONE) {
        TIFFSetField(tiff, TIFFTAG_PREDICTOR, packed.predictor);
    }
    if (packed.isFloat) {
        writePixels<float>(tiff, packed.isTiled);
    } else {
        writePixels<std::uint16_t>(tiff, packed.isTiled);
    }
    TIFFClose(tiff);
    return contentOf(path);
}

void expectPacked(const PackedTiff& packed) {
    const HeightMap map = readAsTiff(packedTiff(packed)).channels.at(0).map;
    ASSERT_EQ(map.columns, kTiffColumns);
    ASSERT_EQ(map.rows, kTiffRows);
    for (int row = 0; row < kTiffRows; ++row) {
        for (int column = 0; column < kTiffColumns; ++column) {
            const double height = heightOf(row, column);
            ASSERT_EQ(map.at(row, column), packed.isFloat ? height : std::floor(height))
                << row << ' ' << column;
        }
    }
}

int errorsOfLibrary = 0;
void countError(const char* /*module*/, const char* /*format*/, va_list /*arguments*/) {
    ++errorsOfLibrary;
}

}  // namespace

TEST(TiffReader, ReadsEveryTypeInBothByteOrdersAndWidths) {
    for (const SampleType type : {SampleType::UInt16, SampleType::Int16, SampleType::UInt32,
                                  SampleType::Int32, SampleType::Float32, SampleType::Float64}) {
        for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
            for (const bool big : {false, true}) {
                TiffTestImage image{.type = type};
                const HeightMap map = readAsTiff(tiffFile({image}, order, big)).channels.at(0).map;
                EXPECT_EQ(map.columns, 3);
                EXPECT_EQ(map.rows, 4);
                EXPECT_EQ(map.heights, image.values);
            }
        }
    }
}

TEST(TiffReader, StripsLieAnywhereAndTheLastOneIsShort) {
    EXPECT_EQ(tiffChannel({.lastStripFirst = true}).map.heights, TiffTestImage{}.values);
    EXPECT_EQ(tiffChannel({.rowsPerStrip = 3}).map.heights, TiffTestImage{}.values);
    EXPECT_EQ(
        tiffChannel({.rowsPerStrip = 4, .extra = {tiffInteger(278, 4294967295.0)}}).map.heights,
        TiffTestImage{}.values);
}

TEST(TiffReader, OrientationSaysWhichRowIsStoredFirst) {
    const ScanChannel bottomFirst = tiffChannel({.extra = {tiffInteger(274, 4)}});
    EXPECT_EQ(bottomFirst.map.at(0, 0), 10.0);
    EXPECT_EQ(bottomFirst.map.at(3, 2), 3.0);
    const ScanChannel turned = tiffChannel({.extra = {tiffInteger(274, 6)}});
    EXPECT_EQ(turned.map.at(0, 0), 1.0);
    EXPECT_THAT(turned.notes, testing::Contains(HasSubstr("orientation 6 is not applied")));
}

TEST(TiffReader, TilesLargerThanTheImageAreRefusedBeforeThereIsRoomForOne) {
    const std::vector<TiffTestField> tile = {tiffInteger(322, 32768), tiffInteger(323, 32768),
                                             tiffInteger(324, 8), tiffInteger(325, 24)};
    EXPECT_THAT(refusalOfTiff({.extra = tile}), HasSubstr("larger than the image"));
}

TEST(TiffReader, DecodesWhatTheLibraryPacks) {
    for (const std::uint16_t compression :
         {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
        for (const bool isTiled : {false, true}) {
            for (const bool isFloat : {false, true}) {
                for (const char* mode : {"w", "wb", "w8"}) {
                    SCOPED_TRACE(std::to_string(compression) + mode);
                    expectPacked({.compression = compression,
                                  .isTiled = isTiled,
                                  .isFloat = isFloat,
                                  .mode = mode});
                }
            }
        }
    }
    expectPacked({.predictor = PREDICTOR_FLOATINGPOINT});
    expectPacked({.predictor = PREDICTOR_HORIZONTAL, .isTiled = true, .isFloat = false});
}

TEST(TiffReader, RefusesDamagedPixelsWithoutAnyHandlerOfTheWholeProgram) {
    std::string bytes = packedTiff({});
    for (std::size_t i = 8; i < 60; ++i) {
        bytes[i] = '\xFF';
    }
    errorsOfLibrary = 0;
    const TIFFErrorHandler before = TIFFSetErrorHandler(countError);
    const TIFFErrorHandler warner = TIFFSetWarningHandler(countError);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&bytes] {
            EXPECT_THAT(refusalOfTiff(bytes), HasSubstr("the TIFF library cannot decode it"));
        });
    }
    threads.clear();
    TIFFSetErrorHandler(before);
    TIFFSetWarningHandler(warner);
    EXPECT_EQ(errorsOfLibrary, 0);
}

TEST(TiffReader, WhereWhiteIsZeroTheLargestCountIsTheLowest) {
    const ScanChannel channel = tiffChannel({.photometric = 0});
    EXPECT_EQ(channel.map.at(0, 0), 65534.0);
    EXPECT_EQ(channel.map.at(3, 2), 65523.0);
    EXPECT_EQ(tiffChannel({.type = SampleType::Float32, .photometric = 0}).map.at(0, 0), 1.0);
}

TEST(TiffReader, NanIsAPixelWithoutData) {
    TiffTestImage image{.type = SampleType::Float32};
    image.values[4] = std::numeric_limits<double>::quiet_NaN();
    const HeightMap map = tiffChannel(image).map;
    EXPECT_TRUE(map.invalid.at(4));
    EXPECT_EQ(std::ranges::count(map.invalid, true), 1);
}

TEST(TiffReader, PicturesAreRefusedInWords) {
    EXPECT_THAT(refusalOfTiff({.type = SampleType::UInt8}), HasSubstr("a picture of 8-bit gray"));
    EXPECT_THAT(refusalOfTiff({.type = SampleType::UInt8, .photometric = 3}), HasSubstr("palette"));
    EXPECT_THAT(refusalOfTiff({.columns = 1, .samplesPerPixel = 3, .photometric = 2}),
                HasSubstr("a color picture"));
}

/// Colors of a screen are no heights, whatever the user says of them.
TEST(TiffReader, PicturesAreRefusedWhateverScaleIsGiven) {
    const ScratchFolder folder;
    for (const TiffTestImage& picture :
         {TiffTestImage{.type = SampleType::UInt8},
          TiffTestImage{.type = SampleType::UInt8, .photometric = 3}}) {
        const auto path = folder.write("picture.tif", tiffFile({picture}));
        EXPECT_THAT(refusalOf([&] {
                        ScanFile(path, {1e-6, 1e-6, 1e-9}, {});
                    }),
                    HasSubstr("picture"));
    }
}

TEST(TiffReader, EachPageIsAChannelButPicturesAndSmallCopies) {
    const TiffTestImage copy{.extra = {tiffInteger(254, 1)}};
    const HeightMapFile file = readAsTiff(
        tiffFile({{}, copy, {.type = SampleType::UInt8}, {.type = SampleType::Float32}}));
    ASSERT_EQ(file.channels.size(), 2U);
    EXPECT_EQ(file.channels[0].name, "gray, image 1");
    EXPECT_EQ(file.channels[1].name, "gray, image 4");
    EXPECT_THAT(file.notes, ElementsAre(HasSubstr("image 3 is a picture of 8-bit gray")));
}

TEST(TiffReader, WithoutScaleValuesAreNumbersAndTheSizeIsUnknown) {
    const ScanChannel channel = tiffChannel({});
    EXPECT_EQ(channel.unit, "");
    EXPECT_FALSE(channel.hasSize());
    EXPECT_THAT(channel.notes, Contains(HasSubstr("no lateral size")));
}

TEST(TiffReader, ResolutionIsTheLateralSizeUnlessItIsThatOfAPrint) {
    TiffTestImage image{.extra = {{.tag = 282, .type = 5, .numbers = {20000}},
                                  {.tag = 283, .type = 5, .numbers = {10000}},
                                  tiffInteger(296, 3)}};
    const ScanChannel channel = tiffChannel(image);
    ASSERT_TRUE(channel.hasSize());
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 0.5e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 1e-6);
    image.extra[0].numbers = image.extra[1].numbers = {300};
    image.extra[2] = tiffInteger(296, 2);
    const ScanChannel print = tiffChannel(image);
    EXPECT_FALSE(print.hasSize());
    EXPECT_THAT(print.notes, Contains(HasSubstr("resolution is that of a print")));
    image.extra[0].numbers = {0};
    EXPECT_FALSE(tiffChannel(image).hasSize());
}

TEST(TiffReader, ImageJSaysItsUnitAndItsCalibration) {
    const TiffTestImage image{
        .extra = {tiffText(270, "ImageJ=1.53t\nunit=micron\ncf=0\nc0=-10\nc1=2\nvunit=nm\n"
                                "min=0.0\nmax=65535.0\n"),
                  {.tag = 282, .type = 5, .numbers = {4}},
                  {.tag = 283, .type = 5, .numbers = {8}},
                  tiffInteger(296, 1)}};
    const ScanChannel channel = tiffChannel(image);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_NEAR(channel.map.at(0, 0), -8e-9, 1e-20);
    EXPECT_NEAR(channel.map.at(3, 2), 14e-9, 1e-20);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, 0.25e-6);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, 0.125e-6);
}

TEST(TiffReader, GwyddionsKeysInTheDescriptionAreTheScale) {
    const std::string size = "Gwy::Title=Höhe\nGwy::XReal=3\nGwy::YReal=8\nGwy::XOffset=-1\n"
                             "Gwy::XYUnit=um\nGwy::ZUnit=nm\n";
    const ScanChannel floats =
        tiffChannel({.type = SampleType::Float32, .extra = {tiffText(270, size)}});
    EXPECT_EQ(floats.name, "Höhe");
    EXPECT_EQ(floats.unit, "m");
    EXPECT_DOUBLE_EQ(floats.map.pitchX, 1e-6);
    EXPECT_DOUBLE_EQ(floats.map.pitchY, 2e-6);
    EXPECT_DOUBLE_EQ(floats.originX, -1e-6);
    EXPECT_DOUBLE_EQ(floats.map.at(0, 1), 2e-9);
    const ScanChannel counts =
        tiffChannel({.extra = {tiffText(270, size + "Gwy::ZMin=-100\nGwy::ZMax=65435\n")}});
    EXPECT_NEAR(counts.map.at(0, 0), -99e-9, 1e-18);
    EXPECT_EQ(tiffChannel({.extra = {tiffText(270, size)}}).unit, "");
    EXPECT_THAT(refusalOfTiff({.extra = {tiffText(270, "Gwy::XReal=wide\n")}}),
                HasSubstr("Gwy::XReal"));
}

TEST(TiffReader, RefusesWhatDoesNotFitTogether) {
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(256, 70000)}}), HasSubstr("pixels"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(257, 0)}}), HasSubstr("pixels"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(257, 400)}}), HasSubstr("strips"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(256, 4)}}), HasSubstr("expected 16 or more"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(278, 0)}}), HasSubstr("rows a strip"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffInteger(259, 7)}}), HasSubstr("method 7"));
    EXPECT_THAT(refusalOfTiff({.extra = {tiffText(256, "3")}}), HasSubstr("tag 256"));
    EXPECT_THAT(refusalOfTiff({.extra = {{.tag = 273, .type = 4, .numbers = {8, 4e9}}}}),
                HasSubstr("beyond the end"));
    EXPECT_THAT(refusalOfTiff({.extra = {{.tag = 279, .type = 4, .numbers = {12, 400}}}}),
                HasSubstr("beyond the end"));
}

TEST(TiffReader, ImagesThatShareTheirPixelsAreDamaged) {
    std::vector<TiffTestImage> images;
    for (int i = 0; i < 40; ++i) {
        images.push_back({.extra = {{.tag = 273, .type = 4, .numbers = {8, 8}},
                                    {.tag = 279, .type = 4, .numbers = {400, 400}}}});
    }
    EXPECT_THAT(refusalOfTiff(tiffFile(images)), HasSubstr("overlap"));
}

/// 100 images of 32 MB each in 3 MB took a minute one after the other.
TEST(TiffReader, RefusesManyImagesOfFarMoreBytesThanTheyArePackedIn) {
    const TiffTestImage image{.columns = 400,
                              .rows = 400,
                              .rowsPerStrip = 400,
                              .values = std::vector<double>(160'000),
                              .extra = {tiffInteger(256, 16384),
                                        tiffInteger(257, 16384),
                                        {.tag = 278, .type = 4, .numbers = {16384}},
                                        tiffInteger(259, 8)}};
    EXPECT_EQ(refusalOf([&] {
                  (void)contentsOf(OwnedBytes(tiffFile({image, image}), "a.tif"), {});
              }),
              "")
        << "1 GiB may be packed in any way";
    EXPECT_THAT(refusalOfTiff(tiffFile({image, image, image})),
                AllOf(HasSubstr("image 3: its images decode to 1.61 GB or more"),
                      HasSubstr("at most 1.07 GB are expected")));
}

/// Each needs a byte of the file, but 32 of memory.
TEST(TiffReader, FarTooManyStripsAreRefusedBeforeTheyAreRead) {
    constexpr std::size_t kOneTooMany = (std::size_t{1} << 20U) + 1;
    const TiffTestImage image{
        .extra = {{.tag = 279, .type = 1, .numbers = {}, .bytes = std::string(kOneTooMany, '\0')}}};
    EXPECT_THAT(refusalOfTiff(image), HasSubstr("at most 1048576 numbers"));
}

/// Each needs 12 bytes of the file, but 24 of memory; in an archive the file's may be packed.
TEST(TiffReader, FarTooManyFieldsInAllAreRefused) {
    TiffTestImage image;
    for (std::uint16_t tag = 1000; tag < 61000; ++tag) {
        image.extra.push_back(tiffInteger(tag, 1));
    }
    EXPECT_THAT(refusalOfTiff(tiffFile({image, image, image, image, image})),
                HasSubstr("directory 5: expected at most 262144 fields in all directories"));
}

TEST(TiffReader, WholeImagesOfATruncatedFileOpenWithANote) {
    const std::string bytes = tiffFile({{}, {}});
    const HeightMapFile cut =
        readHeightMapBytes(std::string_view(bytes).substr(0, bytes.size() - 1), "cut.tif");
    EXPECT_EQ(cut.channels.size(), 1U);
    EXPECT_THAT(cut.notes, testing::Contains(HasSubstr("truncated")));
}

TEST(TiffReader, DirectoriesInACircleAreRefused) {
    std::string bytes = tiffFile({{}, {}});
    const std::string first = bytes.substr(4, 4);
    bytes.replace(bytes.size() - 4, 4, first);
    EXPECT_THAT(refusalOfTiff(bytes), HasSubstr("each once"));
    bytes.replace(4, 4, std::string("\xF0\xFF\xFF\xFF", 4));
    EXPECT_THAT(refusalOfTiff(bytes), HasSubstr("truncated or damaged"));
    bytes.replace(4, 4, std::string(4, '\0'));
    EXPECT_THAT(refusalOfTiff(bytes), HasSubstr("first directory"));
}

TEST(TiffReader, EveryBitOfASmallFileMayFlip) {
    for (const std::string& bytes : {tiffFile({{}}), tiffFile({{}}, ByteOrder::Big, true)}) {
        for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
            for (unsigned bit = 0; bit < 8; ++bit) {
                std::string damaged = bytes;
                damaged[offset] =
                    static_cast<char>(static_cast<unsigned char>(damaged[offset]) ^ (1U << bit));
                try {
                    (void)readAsTiff(damaged);
                } catch (const InputError&) {
                }
            }
            EXPECT_THROW((void)readAsTiff(bytes.substr(0, offset)), InputError) << offset;
        }
    }
}

}  // namespace asperity::test
