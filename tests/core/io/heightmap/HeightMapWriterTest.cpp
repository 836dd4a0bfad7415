#include "core/io/heightmap/HeightMapWriter.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/ImageFiles.h"
#include "tests/support/ProgressRecorder.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

// What is written reads back: by our own readers, or by the libraries of the format.

namespace asperity::test {

namespace {

using testing::HasSubstr;

const HeightMapMeta kMeta{.title = "Höhe 1", .originX = 1e-6, .originY = -2e-6};

/// Writes, reads with our own reader, and gives the only channel.
ScanChannel throughFile(const std::string& name, const HeightMap& map) {
    const ScratchFolder folder;
    writeHeightMap(folder.file(name), map, kMeta);
    return readHeightMapFile(folder.file(name)).channels.at(0);
}

void expectFloatHeights(const std::vector<double>& values, const HeightMap& map) {
    ASSERT_EQ(values.size(), map.heights.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(map.heights[i])) {
            EXPECT_TRUE(std::isnan(values[i])) << i;
        } else {
            EXPECT_EQ(values[i], static_cast<double>(static_cast<float>(map.heights[i]))) << i;
        }
    }
}

void expectSameFrame(const ScanChannel& channel, const HeightMap& map) {
    EXPECT_EQ(channel.map.columns, map.columns);
    EXPECT_EQ(channel.map.rows, map.rows);
    EXPECT_DOUBLE_EQ(channel.map.pitchX, map.pitchX);
    EXPECT_DOUBLE_EQ(channel.map.pitchY, map.pitchY);
    EXPECT_EQ(channel.unit, "m");
    EXPECT_EQ(channel.lateralUnit, "m");
    EXPECT_EQ(channel.name, kMeta.title);
    EXPECT_DOUBLE_EQ(channel.originX, kMeta.originX);
    EXPECT_DOUBLE_EQ(channel.originY, kMeta.originY);
    EXPECT_EQ(channel.map.invalid, map.invalid);
}

std::vector<HeightMap> writtenMaps() {
    return {bumpyMap(7, 4), bumpyMap(1, 9), bumpyMap(9, 1), bumpyMap(1, 1),
            bumpyMapWithHoles(5, 3)};
}

}  // namespace

TEST(HeightMapWriter, GwyKeepsEveryBit) {
    for (const HeightMap& map : writtenMaps()) {
        const ScanChannel channel = throughFile("map.gwy", map);
        expectSameFrame(channel, map);
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            const bool equal = channel.map.heights[i] == map.heights[i] ||
                               (std::isnan(channel.map.heights[i]) && std::isnan(map.heights[i]));
            EXPECT_TRUE(equal) << i;
        }
    }
}

TEST(HeightMapWriter, GwyHoldsNoNan) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.gwy"), bumpyMapWithHoles(5, 3), kMeta);
    const std::string bytes = contentOf(folder.file("map.gwy"));
    const std::size_t data = bytes.find(std::string("data\0D", 6)) + 10;
    for (std::size_t i = 0; i < 15; ++i) {
        double value = 0.0;
        std::copy_n(bytes.data() + data + 8 * i, 8, reinterpret_cast<char*>(&value));
        EXPECT_TRUE(std::isfinite(value)) << i;
    }
}

TEST(HeightMapWriter, GsfRoundsToFloat) {
    for (const HeightMap& map : writtenMaps()) {
        const ScanChannel channel = throughFile("map.gsf", map);
        expectSameFrame(channel, map);
        expectFloatHeights(channel.map.heights, map);
    }
}

TEST(HeightMapWriter, ExrHoldsFloatMetersAndGwyddionsAttributes) {
    for (const HeightMap& map : writtenMaps()) {
        const ScratchFolder folder;
        writeHeightMap(folder.file("map.exr"), map, kMeta);
        const PlainImage image = readExr(folder.file("map.exr"));
        ASSERT_EQ(image.columns, map.columns);
        expectFloatHeights(image.values, map);
        EXPECT_EQ(parseNumber(image.text.at("Gwy::XReal")), map.sizeX());
        EXPECT_EQ(parseNumber(image.text.at("Gwy::YReal")), map.sizeY());
        EXPECT_EQ(parseNumber(image.text.at("Gwy::YOffset")), kMeta.originY);
        EXPECT_EQ(parseNumber(image.text.at("Gwy::ZScale")), 1.0);
        EXPECT_EQ(image.text.at("Gwy::ZUnit"), "m");
        EXPECT_EQ(image.text.at("Gwy::Title"), kMeta.title);
    }
}

TEST(HeightMapWriter, TiffHoldsFloatMetersAndItsSize) {
    for (const HeightMap& map : writtenMaps()) {
        const ScratchFolder folder;
        writeHeightMap(folder.file("map.tiff"), map, kMeta);
        const PlainImage image = readTiff(folder.file("map.tiff"));
        ASSERT_EQ(image.columns, map.columns);
        expectFloatHeights(image.values, map);
        EXPECT_EQ(image.text.at("format"), "3");
        EXPECT_NEAR(parseNumber(image.text.at("x per cm")).value() * map.pitchX, 0.01, 1e-8);
        EXPECT_THAT(image.text.at("description"),
                    HasSubstr("Gwy::XReal=" + exactText(map.sizeX())));
    }
}

TEST(HeightMapWriter, PicturesReadBackWithTheirScale) {
    for (const HeightMap& map : writtenMaps()) {
        for (const char* name : {"map.exr", "map.tiff"}) {
            SCOPED_TRACE(name);
            const ScanChannel channel = throughFile(name, map);
            expectSameFrame(channel, map);
            expectFloatHeights(channel.map.heights, map);
        }
    }
    const HeightMap map = bumpyMap(7, 4);
    const ScanChannel channel = throughFile("map.png", map);
    expectSameFrame(channel, map);
    const auto [lowest, highest] = std::ranges::minmax(map.heights);
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        EXPECT_NEAR(channel.map.heights[i], map.heights[i],
                    0.5000001 * (highest - lowest) / 65535.0);
    }
}

TEST(HeightMapWriter, PngIsWithinHalfAStepOfItsScale) {
    for (const HeightMap& map : writtenMaps()) {
        const ScratchFolder folder;
        writeHeightMap(folder.file("map.png"), map, kMeta);
        const PlainImage image = readPng(folder.file("map.png"));
        ASSERT_EQ(image.columns, map.columns);
        ASSERT_EQ(image.text.at("bits"), "16");
        const double black = parseNumber(image.text.at("Gwy::ZMin")).value();
        const double white = parseNumber(image.text.at("Gwy::ZMax")).value();
        const double step = (white - black) / 65535.0;
        EXPECT_EQ(parseNumber(image.text.at("Gwy::XReal")), map.sizeX());
        EXPECT_EQ(image.text.at("Gwy::Title"), kMeta.title);
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            const double height = std::isnan(map.heights[i]) ? black : map.heights[i];
            EXPECT_NEAR(black + step * image.values[i], height, 0.5000001 * step) << i;
        }
        EXPECT_EQ(image.text.contains("Comment"), !map.invalid.empty());
    }
}

TEST(HeightMapWriter, TextReadsBackToTheSameBits) {
    for (const HeightMap& map : writtenMaps()) {
        const ScratchFolder folder;
        writeHeightMap(folder.file("map.txt"), map, kMeta);
        std::istringstream text(contentOf(folder.file("map.txt")));
        std::string line;
        std::getline(text, line);
        EXPECT_EQ(line, "# File Format = ASCII");
        while (line != "# Channel: Höhe 1" && std::getline(text, line)) {
            EXPECT_TRUE(line.starts_with("# ")) << line;
        }
        EXPECT_EQ(line, "# Channel: Höhe 1");
        std::getline(text, line);
        EXPECT_EQ(line, "# Width: " + exactText(map.sizeX()) + " m");
        std::getline(text, line);
        EXPECT_EQ(line, "# Height: " + exactText(map.sizeY()) + " m");
        std::getline(text, line);
        EXPECT_EQ(line, "# Value units: m");
        std::getline(text, line);
        EXPECT_EQ(line, "# X offset: 1e-06 m");
        std::getline(text, line);
        EXPECT_EQ(line, "# Y offset: -2e-06 m");
        std::getline(text, line);
        EXPECT_EQ(line, "# Start of Data:");
        for (int row = 0; row < map.rows; ++row) {
            ASSERT_TRUE(std::getline(text, line));
            std::istringstream cells(line);
            std::string cell;
            for (int column = 0; column < map.columns; ++column) {
                ASSERT_TRUE(std::getline(cells, cell, '\t'));
                if (map.isValid(row, column)) {
                    EXPECT_EQ(parseNumber(cell), map.at(row, column));
                } else {
                    EXPECT_EQ(cell, "nan");
                }
            }
        }
        EXPECT_FALSE(std::getline(text, line));
    }
}

/// Every map was one of heights in meters, whatever its values were.
/// A title of a file from somewhere else colored the terminal that showed the text.
TEST(HeightMapWriter, TextsHoldNoCommandsForATerminal) {
    const ScratchFolder folder;
    const HeightMapMeta meta{.title = "a\x1b[31mred\x07",
                             .unit = "V\x1b[m",
                             .metadata = {{"Key\x1b[1m", "of\ttwo\nlines\x1b[2m"}}};
    for (const char* const name : {"a.txt", "a.gsf", "a.tiff", "a.png", "a.vti", "a.exr"}) {
        const std::filesystem::path file = folder.file(name);
        writeHeightMap(file, rowsOf(bumpyMap(8, 8)), meta);
        std::ostringstream bytes;
        bytes << std::ifstream(file, std::ios::binary).rdbuf();
        EXPECT_EQ(bytes.str().find("\x1b["), std::string::npos) << name;
        EXPECT_EQ(bytes.str().find("red\x07"), std::string::npos) << name;
    }
    const HeightMapFile read = readHeightMapFile(folder.file("a.gsf"));
    EXPECT_EQ(read.channels.at(0).name, "a\\e[31mred\\x07");
    EXPECT_EQ(read.channels.at(0).unit, "V\\e[m");
    EXPECT_EQ(read.channels.at(0).metadata.at("Key\\e[1m"), "of two lines\\e[2m");
}

TEST(HeightMapWriter, NumbersWithoutAUnitAreNoHeights) {
    const ScratchFolder folder;
    const HeightMapMeta numbers{.title = "Certainty", .unit = ""};
    const auto written = [&](const char* name) {
        writeHeightMap(folder.file(name), rowsOf(bumpyMap(7, 4)), numbers);
        return folder.file(name);
    };
    for (const char* name : {"map.gwy", "map.gsf"}) {
        const ScanChannel channel = readHeightMapFile(written(name)).channels.at(0);
        EXPECT_EQ(channel.unit, "") << name;
        EXPECT_EQ(channel.lateralUnit, "m") << name;
        EXPECT_DOUBLE_EQ(channel.map.pitchX, bumpyMap(7, 4).pitchX) << name;
    }
    EXPECT_EQ(readExr(written("map.exr")).text.at("Gwy::ZUnit"), "");
    EXPECT_EQ(readPng(written("map.png")).text.at("Gwy::ZUnit"), "");
    EXPECT_THAT(readTiff(written("map.tiff")).text.at("description"), HasSubstr("Gwy::ZUnit=\n"));
    EXPECT_THAT(contentOf(written("map.txt")), testing::Not(HasSubstr("Value units")));
}

TEST(HeightMapWriter, FlatAndEmptyMapsAreLegal) {
    HeightMap flat = bumpyMap(2, 2);
    flat.heights.assign(4, 3e-9);
    HeightMap nothing = flat;
    nothing.heights.assign(4, std::numeric_limits<double>::quiet_NaN());
    for (const std::string& extension : heightMapExtensions()) {
        const ScratchFolder folder;
        writeHeightMap(folder.file("flat" + extension), flat, kMeta);
        writeHeightMap(folder.file("nothing" + extension), nothing, kMeta);
        EXPECT_GT(std::filesystem::file_size(folder.file("nothing" + extension)), 0U);
    }
    EXPECT_EQ(throughFile("flat.gwy", flat).map.heights, flat.heights);
    EXPECT_EQ(throughFile("nothing.gwy", nothing).map.invalid, PixelMask(4, 1));
}

TEST(HeightMapWriter, RefusesUnknownExtensionsAndUnusableMaps) {
    const ScratchFolder folder;
    try {
        writeHeightMap(folder.file("map.jpeg"), bumpyMap(2, 2), kMeta);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("map.jpeg"), HasSubstr(".gwy .gsf")));
    }
    EXPECT_NE(writeRefusal("map"), "");
    EXPECT_EQ(writeRefusal("MAP.GSF"), "");
    HeightMap wrong = bumpyMap(2, 2);
    wrong.heights.pop_back();
    EXPECT_THROW(writeHeightMap(folder.file("map.gsf"), wrong, kMeta), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(HeightMapWriter, TellsHowFarItIs) {
    const ScratchFolder folder;
    const HeightMap map = bumpyMapWithHoles(5, 300);
    for (const std::string& extension : heightMapExtensions()) {
        ProgressRecorder recorder(2.0);
        writeHeightMap(folder.file("map" + extension), rowsOf(map), kMeta, &recorder);
        EXPECT_GE(recorder.fractions.size(), 40U) << extension;
        EXPECT_TRUE(std::ranges::is_sorted(recorder.fractions)) << extension;
        EXPECT_EQ(recorder.fractions.back(), 1.0) << extension;
    }
}

TEST(HeightMapWriter, CanceledLeavesNothingBehind) {
    const ScratchFolder folder;
    const HeightMap map = bumpyMapWithHoles(5, 300);
    for (const std::string& extension : heightMapExtensions()) {
        for (const double fraction : {0.0, 0.3, 0.9}) {
            ProgressRecorder recorder(fraction);
            EXPECT_THROW(
                writeHeightMap(folder.file("map" + extension), rowsOf(map), kMeta, &recorder),
                Canceled);
            EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << extension << fraction;
        }
    }
}

/// The format's sizes have 32 bits; a file of 4 GiB must not be written to find that out.
TEST(HeightMapWriter, RefusesWhatIsTooLargeForGwyddionAtOnce) {
    const ScratchFolder folder;
    const HeightRows rows{.columns = 65536,
                          .rows = 8192,
                          .pitchX = 1e-9,
                          .pitchY = 1e-9,
                          .readRow = [](int, double*) { FAIL(); }};
    EXPECT_THROW(writeHeightMap(folder.file("map.gwy"), rows, kMeta), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(HeightMapWriter, FailedWriteLeavesNothingBehind) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.file("taken.gsf"));
    EXPECT_THROW(writeHeightMap(folder.file("taken.gsf"), bumpyMap(2, 2), kMeta), Error);
    EXPECT_THROW(writeHeightMap(folder.file("none") / "map.gsf", bumpyMap(2, 2), kMeta), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace asperity::test
