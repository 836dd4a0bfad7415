#include "core/io/heightmap/ThinnedMap.h"

#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {
namespace {

class ThinnedMapTest : public testing::Test {
protected:
    ThinnedMapTest() { writeHeightMap(path, bumpyMapWithHoles(40, 30), {}); }

    ScratchFolder folder;
    std::filesystem::path path = folder.file("a.gwy");
};

TEST_F(ThinnedMapTest, IsAllOfASmallOne) {
    const ScanFile file(path);
    const ScanChannel& channel = file.contents().channels.front();
    const ThinnedMap thin = thinnedMap(file, channel, {0, 0, 40, 30});
    const HeightMap whole = file.readHeightChannel("").channel.map;
    EXPECT_EQ(thin.step, 1);
    ASSERT_EQ(thin.map.heights.size(), whole.heights.size());
    EXPECT_EQ(thin.map.invalid, whole.invalid);
    EXPECT_EQ(thin.map.at(17, 23), whole.at(17, 23));
    EXPECT_EQ(thin.map.pitchX, whole.pitchX);
}

/// 40 x 30 pixels in at most 100: every fourth, 10 x 8.
TEST_F(ThinnedMapTest, LeavesPixelsAtEvenDistancesAndTheSizeAsItIs) {
    const ScanFile file(path);
    const ScanChannel& channel = file.contents().channels.front();
    const HeightMap whole = file.readHeightChannel("").channel.map;
    const ThinnedMap thin = thinnedMap(file, channel, {0, 0, 40, 30}, nullptr, 100);
    EXPECT_EQ(thin.step, 4);
    ASSERT_EQ(thin.map.columns, 10);
    ASSERT_EQ(thin.map.rows, 8);
    EXPECT_EQ(thin.map.at(0, 0), whole.at(2, 2));
    EXPECT_EQ(thin.map.at(3, 5), whole.at(14, 22));
    EXPECT_EQ(thin.map.at(7, 9), whole.at(29, 38)) << "the last one that there is";
    EXPECT_DOUBLE_EQ(thin.map.sizeX(), whole.sizeX());
}

TEST_F(ThinnedMapTest, ReadsAPart) {
    const ScanFile file(path);
    const ScanChannel& channel = file.contents().channels.front();
    const HeightMap whole = file.readHeightChannel("").channel.map;
    const ThinnedMap thin = thinnedMap(file, channel, {10, 20, 8, 6}, nullptr, 12);
    EXPECT_EQ(thin.step, 2);
    EXPECT_EQ(thin.map.columns, 4);
    EXPECT_EQ(thin.map.rows, 3);
    EXPECT_EQ(thin.map.at(1, 2), whole.at(23, 15));
}

TEST_F(ThinnedMapTest, TellsStatisticsOfWhatHoldsData) {
    HeightMap map = bumpyMap(3, 1);
    map.heights = {1e-9, std::nan(""), 3e-9};
    map.invalid = {false, true, false};
    const HeightStatistics statistics = heightStatistics(map);
    EXPECT_EQ(statistics.lowest, 1e-9);
    EXPECT_EQ(statistics.highest, 3e-9);
    EXPECT_DOUBLE_EQ(statistics.rms, 1e-9);
    EXPECT_EQ(statistics.invalidPixels, 1U);
}

}  // namespace
}  // namespace asperity::test
