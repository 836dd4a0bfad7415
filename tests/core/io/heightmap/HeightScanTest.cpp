#include "core/Error.h"
#include "core/Units.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace asperity::test {

namespace {

/// Both ways of reading a file give the same map, but for single precision.
void expectSameMap(const std::filesystem::path& path) {
    const HeightMapFile file = readHeightMapFile(path);
    const ScanChannel& channel = heightChannel(file, path, "");
    const HeightScan scan = readHeightScan(path, "");
    EXPECT_EQ(scan.format, file.format);
    EXPECT_EQ(scan.channel, channel.name);
    EXPECT_EQ(scan.notes, notesOn(file, channel));
    EXPECT_EQ(scan.map.columns, channel.map.columns);
    EXPECT_EQ(scan.map.rows, channel.map.rows);
    EXPECT_EQ(scan.map.pitchX, channel.map.pitchX);
    EXPECT_EQ(scan.map.pitchY, channel.map.pitchY);
    EXPECT_EQ(scan.map.invalid, channel.map.invalid);
    ASSERT_EQ(scan.map.heights.size(), channel.map.heights.size());
    double largest = 0.0;
    for (const double height : channel.map.heights) {
        largest =
            std::isnan(height) ? largest : std::max(largest, std::abs(height - scan.map.datum));
    }
    for (std::size_t i = 0; i < scan.map.heights.size(); ++i) {
        const double height = scan.map.datum + static_cast<double>(scan.map.heights[i]);
        ASSERT_EQ(std::isnan(height), std::isnan(channel.map.heights[i]));
        if (!std::isnan(height)) {
            ASSERT_NEAR(height, channel.map.heights[i], 0x1p-24 * largest);
        }
    }
}

/// Heights of micrometers with differences of nanometers, and two pixels without data.
HeightMap highMap() {
    HeightMap map = bumpyMap(37, 23);
    for (double& height : map.heights) {
        height += 3.0_um;
    }
    map.invalid.assign(map.heights.size(), 0);
    for (const std::size_t pixel : {std::size_t{0}, std::size_t{100}}) {
        map.heights[pixel] = kNan;
        map.invalid[pixel] = 1;
    }
    return map;
}

/// Enough pixels for two threads, and a first row without data.
HeightMap largeMap() {
    HeightMap map = bumpyMap(700, 500);
    map.invalid.assign(map.heights.size(), 0);
    const auto remove = [&map](std::size_t pixel) {
        map.heights[pixel] = kNan;
        map.invalid[pixel] = 1;
    };
    for (std::size_t column = 0; column < 700; ++column) {
        remove(column);
    }
    remove(map.index(250, 3));
    remove(map.index(499, 699));
    return map;
}

}  // namespace

TEST(HeightScan, IsTheMapInSinglePrecision) {
    const ScratchFolder folder;
    for (const char* name : {"map.gsf", "map.gwy"}) {
        writeHeightMap(folder.file(name), highMap(), {.title = "Height"});
        expectSameMap(folder.file(name));
    }
    expectSameMap(folder.write("scan.spm", nanoscopeFile({}, {1, 2, 3, 4, 5, -6})));
}

TEST(HeightScan, IsTheSameMapWhenThreadsShareItsRows) {
    const ScratchFolder folder;
    for (const char* name : {"map.gsf", "map.gwy"}) {
        writeHeightMap(folder.file(name), largeMap(), {.title = "Height"});
        expectSameMap(folder.file(name));
        EXPECT_EQ(readHeightScan(folder.file(name), "").map.datum,
                  readHeightMapFile(folder.file(name)).channels.at(0).map.heights[700]);
    }
}

TEST(HeightScan, TakesTheHeightsAboutTheFirstOfThem) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.gwy"), highMap(), {.title = "Height"});
    EXPECT_EQ(readHeightScan(folder.file("map.gwy"), "").map.datum, highMap().heights[1]);
}

TEST(SceneScan, IsTheMapAsTheFileGivesItUnlessItIsLarge) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.gwy"), largeMap(), {.title = "Height"});
    const SceneScan scan = readSceneScan(folder.file("map.gwy"), "");
    const HeightChannel exact = readHeightChannel(folder.file("map.gwy"), "");
    ASSERT_TRUE(std::holds_alternative<HeightMap>(scan.map));
    EXPECT_EQ(std::get<HeightMap>(scan.map).at(300, 7), exact.channel.map.at(300, 7));
    EXPECT_EQ(scan.channel, "Height");
    EXPECT_EQ(scan.format, readHeightScan(folder.file("map.gwy"), "").format);
    writeHeightMap(folder.file("large.gsf"), bumpyMap(2049, 2048), {.title = "Height"});
    EXPECT_TRUE(std::holds_alternative<ScanMap>(readSceneScan(folder.file("large.gsf"), "").map));
}

TEST(HeightChannel, IsTheMapAsTheFileGivesIt) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.gwy"), largeMap(), {"Height", 1.0_um, 2.0_um});
    const HeightChannel read = readHeightChannel(folder.file("map.gwy"), "");
    const HeightMapFile file = readHeightMapFile(folder.file("map.gwy"));
    const ScanChannel& expected = heightChannel(file, folder.file("map.gwy"), "");
    EXPECT_EQ(read.channel.name, "Height");
    EXPECT_EQ(read.channel.originX, 1.0_um);
    EXPECT_EQ(read.channel.originY, 2.0_um);
    EXPECT_EQ(read.channel.map.pitchX, expected.map.pitchX);
    EXPECT_EQ(read.channel.map.invalid, expected.map.invalid);
    EXPECT_EQ(read.channel.map.at(300, 7), expected.map.at(300, 7));
    EXPECT_EQ(read.notes, notesOn(file, expected));
    const HeightScan scan = readHeightScan(folder.file("map.gwy"), "");
    EXPECT_EQ(scan.originX, 1.0_um);
    EXPECT_EQ(scan.originY, 2.0_um);
    CanceledAfter once(1);
    EXPECT_THROW((void)readHeightChannel(folder.file("map.gwy"), "", &once), Canceled);
}

TEST(HeightScan, RefusesAsTheFileItself) {
    const ScratchFolder folder;
    EXPECT_THROW((void)readHeightScan(folder.file("none.gsf"), ""), InputError);
    EXPECT_THROW((void)readHeightScan(folder.path(), ""), InputError);
    EXPECT_THROW((void)readHeightScan(folder.write("empty.gsf", ""), ""), InputError);
    EXPECT_THROW((void)readHeightScan(folder.write("text.gsf", "no scan"), ""), InputError);
    writeHeightMap(folder.file("map.gsf"), bumpyMap(4, 4), {.title = "Height"});
    EXPECT_THROW((void)readHeightScan(folder.file("map.gsf"), "another"), InputError);
}

TEST(HeightScan, EndsWhenItIsCanceled) {
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.gsf"), bumpyMap(4, 4), {.title = "Height"});
    writeHeightMap(folder.file("large.gsf"), bumpyMap(700, 500), {.title = "Height"});
    CanceledAfter atOnce(0);
    EXPECT_THROW((void)readHeightScan(folder.file("map.gsf"), "", &atOnce), Canceled);
    CanceledAfter once(1);
    EXPECT_THROW((void)readHeightScan(folder.file("large.gsf"), "", &once), Canceled);
}

}  // namespace asperity::test
