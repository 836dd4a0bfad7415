#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/MapStatistics.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// What is written comes back through our own readers, in every format that has both.

namespace asperity::test {

namespace {

constexpr double kFloat = 6e-8;            // of a height: half a step of single precision
constexpr double kHalfStep = 0.5 / 65534;  // of the range: half a step of 16 bits
constexpr double kRounding = 1e-15;        // of the largest height: of the arithmetic

/// A format's promise on its heights.
struct Precision {
    double ofHeight = 0.0;
    double ofRange = 0.0;
};

Precision precisionOf(const std::string& extension) {
    const std::map<std::string, Precision> known = {{".gwy", {}},
                                                    {".txt", {}},
                                                    {".vti", {}},
                                                    {".gsf", {.ofHeight = kFloat}},
                                                    {".exr", {.ofHeight = kFloat}},
                                                    {".tiff", {.ofHeight = kFloat}},
                                                    {".tif", {.ofHeight = kFloat}},
                                                    {".png", {kRounding, kHalfStep}}};
    return known.at(extension);
}

/// With pixels without data, the first among them.
HeightMap withHoles(HeightMap map) {
    map.invalid.assign(map.heights.size(), 0);
    for (std::size_t pixel = 0; pixel < map.heights.size(); pixel += 4) {
        map.invalid[pixel] = 1;
        map.heights[pixel] = std::numeric_limits<double>::quiet_NaN();
    }
    return map;
}

/// Some tenths of a nanometer, 1 um below 0.
HeightMap shallowMap() {
    HeightMap map = bumpyMap(6, 5);
    std::ranges::transform(map.heights, map.heights.begin(),
                           [](double height) { return 0.01 * height - 1e-6; });
    return map;
}

HeightMap flatMap() {
    HeightMap map = bumpyMap(3, 4);
    std::ranges::fill(map.heights, -3e-9);
    return map;
}

HeightMap mapWithoutData() {
    HeightMap map = bumpyMap(3, 4);
    map.invalid.assign(12, 1);
    std::ranges::fill(map.heights, std::numeric_limits<double>::quiet_NaN());
    return map;
}

std::vector<HeightMap> anyMaps() {
    return {bumpyMap(7, 4),          withHoles(bumpyMap(7, 4)),
            bumpyMap(1, 9),          withHoles(bumpyMap(1, 9)),
            bumpyMap(9, 1),          withHoles(bumpyMap(9, 1)),
            bumpyMap(2, 3),          withHoles(bumpyMap(3, 3)),
            bumpyMap(1, 1),          shallowMap(),
            withHoles(shallowMap()), flatMap(),
            withHoles(flatMap()),    mapWithoutData()};
}

void expectHeights(const HeightMap& read, const HeightMap& written, const Precision& precision) {
    ASSERT_EQ(read.heights.size(), written.heights.size());
    EXPECT_EQ(read.invalid, written.invalid);
    const HeightStatistics statistics = statisticsOf(written);
    const double range = statistics.highest - statistics.lowest;
    for (std::size_t i = 0; i < read.heights.size(); ++i) {
        if (std::isnan(written.heights[i])) {
            EXPECT_TRUE(std::isnan(read.heights[i])) << i;
            continue;
        }
        const double bound =
            precision.ofHeight * std::abs(written.heights[i]) + precision.ofRange * range;
        EXPECT_LE(std::abs(read.heights[i] - written.heights[i]), bound) << i;
    }
}

void expectFrame(const ScanChannel& read, const HeightMap& map, const HeightMapMeta& meta) {
    EXPECT_EQ(read.map.columns, map.columns);
    EXPECT_EQ(read.map.rows, map.rows);
    EXPECT_DOUBLE_EQ(read.map.pitchX, map.pitchX);
    EXPECT_DOUBLE_EQ(read.map.pitchY, map.pitchY);
    EXPECT_EQ(read.lateralUnit, "m");
    EXPECT_EQ(read.unit, meta.unit);
    EXPECT_EQ(read.name, meta.title);
    EXPECT_DOUBLE_EQ(read.originX, meta.originX);
    EXPECT_DOUBLE_EQ(read.originY, meta.originY);
}

/// 16-bit TIFF is a choice, and no row of the table.
constexpr std::array kFormatsOfCounts{&kTiffCountsFormat};

class RoundTrip : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] ScanChannel through(const HeightMap& map, const HeightMapMeta& meta) const {
        const ScratchFolder folder;
        writeHeightMap(folder.file("map" + GetParam()), map, meta);
        const HeightMapFile file = readHeightMapFile(folder.file("map" + GetParam()), {});
        EXPECT_EQ(file.channels.size(), 1U);
        return file.channels.at(0);
    }
};

TEST_P(RoundTrip, KeepsHeightsMaskSizeAndOrigin) {
    const HeightMapMeta meta{.title = "Height", .originX = 1.25e-6, .originY = -2e-6};
    for (const HeightMap& map : anyMaps()) {
        SCOPED_TRACE(std::to_string(map.columns) + " x " + std::to_string(map.rows) +
                     (map.invalid.empty() ? "" : " with pixels without data"));
        const ScanChannel read = through(map, meta);
        expectFrame(read, map, meta);
        expectHeights(read.map, map, precisionOf(GetParam()));
    }
}

TEST_P(RoundTrip, KeepsTitlesInAnyScript) {
    for (const char* title :
         {"高さ 10 nm", "Высота (вперёд)", "Höhe, größer", "गहराई", "x = 1: \"a\" <b> & 'c'"}) {
        const HeightMapMeta meta{.title = title};
        expectFrame(through(bumpyMap(4, 3), meta), bumpyMap(4, 3), meta);
    }
}

TEST_P(RoundTrip, KeepsUnitsOfValuesThatAreNoHeights) {
    for (const char* unit : {"V", "deg", "A", ""}) {
        const HeightMapMeta meta{.title = "Signal", .unit = unit};
        const HeightMap map = withHoles(bumpyMap(5, 4));
        const ScanChannel read = through(map, meta);
        expectFrame(read, map, meta);
        expectHeights(read.map, map, precisionOf(GetParam()));
    }
}

TEST_P(RoundTrip, KeepsMetadata) {
    const HeightMapMeta meta{.title = "Height",
                             .metadata = {{"Scan rate", "1.5 Hz"},
                                          {"Operator", "Анна 高"},
                                          {"Title", "of the sample <1>"},
                                          {"Gwy::XReal", "7"},
                                          {"Width", "9 m"},
                                          {"Height", "8 m"},
                                          {"X", "y z"},
                                          {"X offset", "7 m"},
                                          {"Unit", "V"},
                                          {"empty", ""},
                                          {"Note", "two\nlines"}}};
    const ScanChannel read = through(bumpyMap(4, 3), meta);
    expectFrame(read, bumpyMap(4, 3), meta);
    EXPECT_EQ(read.metadata.at("Scan rate"), "1.5 Hz");
    EXPECT_EQ(read.metadata.at("Operator"), "Анна 高");
    const std::string note = read.metadata.at("Note");
    EXPECT_TRUE(note == "two\nlines" || note == "two lines") << note;
}

TEST(RoundTripOfCounts, KeepsHeightsMaskSizeAndOrigin) {
    const HeightMapMeta meta{.title = "高さ", .originX = 1.25e-6, .originY = -2e-6};
    for (const HeightMap& map : anyMaps()) {
        const ScratchFolder folder;
        const std::filesystem::path path = folder.file("map.tif");
        writeHeightMap(path, rowsOf(map), meta, nullptr, kFormatsOfCounts);
        const ScanChannel read = readHeightMapFile(path, {}).channels.at(0);
        expectFrame(read, map, meta);
        expectHeights(read.map, map, {kRounding, kHalfStep});
    }
}

/// A file that is written is read, whatever its instrument's metadata.
TEST_P(RoundTrip, TakesAsMuchMetadataAsItCan) {
    HeightMapMeta meta{.title = "Height"};
    for (int i = 0; i < 40; ++i) {
        meta.metadata["long " + std::to_string(i)] = std::string(50000, 'x') + "\n=:\\\"<>&";
    }
    for (int i = 0; i < 3000; ++i) {
        meta.metadata["short " + std::to_string(i)] = "1 m";
    }
    meta.metadata["tooLong"] = std::string(3'000'000, 'x');
    meta.metadata["X offset: 1 m = \t"] = "5 m";
    meta.metadata[std::string("a\0b\x1b", 4)] = "x";
    const ScanChannel read = through(bumpyMap(4, 3), meta);
    expectFrame(read, bumpyMap(4, 3), meta);
    expectHeights(read.map, bumpyMap(4, 3), precisionOf(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::ValuesIn(heightMapExtensions()),
                         [](const auto& extension) { return extension.param.substr(1); });

}  // namespace
}  // namespace asperity::test
