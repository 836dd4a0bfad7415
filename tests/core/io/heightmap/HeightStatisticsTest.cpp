#include "core/io/heightmap/HeightStatistics.h"

#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/MapStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::test {

TEST(HeightStatistics, SkipInvalidPixels) {
    HeightMap map = bumpyMap(3, 1);
    map.heights = {1.0, std::nan(""), 3.0};
    const HeightStatistics statistics = statisticsOf(map);
    EXPECT_EQ(statistics.lowest, 1.0);
    EXPECT_EQ(statistics.highest, 3.0);
    EXPECT_EQ(statistics.mean, 2.0);
    EXPECT_EQ(statistics.rms, 1.0);
    EXPECT_EQ(statistics.invalidPixels, 1U);
}

TEST(HeightStatistics, OfNothingAreNotNumbers) {
    HeightMap map = bumpyMap(1, 1);
    map.heights = {std::nan("")};
    EXPECT_TRUE(std::isnan(statisticsOf(map).mean));
    EXPECT_EQ(statisticsOf(map).invalidPixels, 1U);
}

TEST(HeightStatistics, AreTheSameInRowsAndInOnePiece) {
    const HeightMap map = bumpyMap(37, 23);
    const HeightStatistics rows = heightStatistics([&map](const TakeRow& take) {
        for (int row = 0; row < map.rows; ++row) {
            take(std::span(map.heights).subspan(map.index(row, 0), 37));
        }
    });
    const HeightStatistics whole = statisticsOf(map);
    EXPECT_EQ(rows.lowest, whole.lowest);
    EXPECT_EQ(rows.highest, whole.highest);
    EXPECT_EQ(rows.mean, whole.mean);
    EXPECT_EQ(rows.rms, whole.rms);
}

/// Each pass over the rows may decode the whole image again.
TEST(HeightStatistics, AskForTheRowsOnce) {
    int passes = 0;
    const std::vector<double> row = {1e-6, 3e-6};
    const HeightStatistics statistics = heightStatistics([&](const TakeRow& take) {
        ++passes;
        for (int i = 0; i < 1000; ++i) {  // more than are summed up at a time
            take(row);
        }
    });
    EXPECT_EQ(passes, 1);
    EXPECT_NEAR(statistics.rms, 1e-6, 1e-20);
}

/// A common height far above the roughness must not swallow it.
TEST(HeightStatistics, KeepASmallRoughnessOnALargeHeight) {
    HeightMap map = bumpyMap(1000, 1);
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] = 1.0 + (i % 2 == 0 ? 1e-12 : -1e-12);
    }
    EXPECT_NEAR(statisticsOf(map).rms, 1e-12, 1e-15);
}

}  // namespace asperity::test
