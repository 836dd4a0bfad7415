#include "core/io/heightmap/HeightStatistics.h"

#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/MapStatistics.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace asperity::test
