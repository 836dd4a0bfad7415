#include "core/Units.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/leveling/ScarRemoval.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

using test::kNan;

/// Offsets of rows that have neither a mean nor a trend.
constexpr double kOffsets[] = {3.0, -1.0, -5.0, 3.0, 3.0, -5.0, -1.0, 3.0};
constexpr int kRows = 8;

/// Large bumps, a tilt along y of `trend` a row and the offsets.
HeightMap shifted(double trend) {
    HeightMap map = flatMap({.columns = 11, .rows = kRows, .sizeX = 11.0, .sizeY = 8.0});
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < 11; ++column) {
            const double island = column < 4 && row > 2 ? 64.0 : 0.0;
            map.heights[map.index(row, column)] = island + kOffsets[row] + trend * row;
        }
    }
    return map;
}

TEST(RowAlignment, MedianOfDifferencesKeepsTheTrendAlongY) {
    const HeightMap level = leveled(shifted(0.5), {LevelingStep::MedianOfDifferences});
    for (int row = 0; row < kRows; ++row) {
        EXPECT_NEAR(level.at(row, 10), 0.5 * row, 1e-14);
        EXPECT_NEAR(level.at(row, 0), 0.5 * row + (row > 2 ? 64.0 : 0.0), 1e-14);
    }
}

TEST(RowAlignment, DifferenceShiftsHoldTheTrend) {
    const RowShifts shifts = differenceShifts(shifted(0.5));
    for (int row = 0; row < kRows; ++row) {
        EXPECT_NEAR(shifts[static_cast<std::size_t>(row)], kOffsets[row] - 3.0 + 0.5 * row, 1e-14);
    }
}

TEST(RowAlignment, TakesTheMeanOfTheTwoMiddleDifferences) {
    HeightMap map = flatMap({.columns = 4, .rows = 2, .sizeX = 4.0, .sizeY = 2.0});
    map.heights = {0.0, 0.0, 0.0, 0.0, 8.0, 1.0, 4.0, 2.0};
    EXPECT_EQ(differenceShifts(map), (RowShifts{0.0, 3.0}));
}

TEST(RowAlignment, RowsWithoutDataAreStridden) {
    HeightMap map = shifted(0.5);
    map.heights[map.index(1, 10)] = kNan;
    map.invalid.assign(map.heights.size(), false);
    for (int column = 0; column < 11; ++column) {
        map.heights[map.index(4, column)] = kNan;
        map.heights[map.index(6, column)] = 1000.0;
        map.invalid[map.index(6, column)] = true;
    }
    const HeightMap level = leveled(map, {LevelingStep::MedianOfDifferences});
    // What is left of the other rows' offsets after their own trend: a straight line.
    const double step = level.at(7, 9) - level.at(5, 9);
    EXPECT_NEAR(level.at(5, 9) - level.at(3, 9), step, 1e-13);
    EXPECT_NEAR(level.at(2, 9) - level.at(0, 9), step, 1e-13);
    EXPECT_TRUE(std::isnan(level.at(4, 3)));
}

TEST(RowAlignment, OfASingleRowChangesNothing) {
    HeightMap map = flatMap({.columns = 3, .rows = 1, .sizeX = 3.0, .sizeY = 1.0});
    map.heights = {1.0, 2.0, 4.0};
    EXPECT_EQ(leveled(map, {LevelingStep::MedianOfDifferences}).heights, map.heights);
}

TEST(RowAlignment, SpreadIsTheStandardDeviationOfRowsWithData) {
    HeightMap map = flatMap({.columns = 1, .rows = 4, .sizeX = 1.0, .sizeY = 4.0});
    map.heights = {0.0, 0.0, kNan, 0.0};
    EXPECT_NEAR(spreadOf({1.0, 3.0, 100.0, 5.0}, map), std::sqrt(8.0 / 3.0), 1e-15);
}

}  // namespace
}  // namespace asperity
