#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/HeightMap.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::kNan;

HeightMap rampMap() {
    HeightMap map = flatMap({.columns = 12, .rows = 10, .sizeX = 12.0_nm, .sizeY = 10.0_nm});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = column;
        }
    }
    return map;
}

TEST(InvalidPixels, ASingleHoleTakesTheMeanAroundIt) {
    HeightMap map = rampMap();
    map.heights[map.index(4, 6)] = kNan;
    const HeightMap whole = withInvalidPixelsFilled(map);
    EXPECT_DOUBLE_EQ(whole.at(4, 6), 6.0);
    EXPECT_FALSE(whole.isValid(4, 6));
    EXPECT_TRUE(whole.isValid(4, 5));
    EXPECT_EQ(std::ranges::count(whole.invalid, 1), 1);
}

TEST(InvalidPixels, ALargeHoleStaysWithinTheHeightsAroundIt) {
    HeightMap map = rampMap();
    for (int row = 2; row < 9; ++row) {
        for (int column = 3; column < 9; ++column) {
            map.heights[map.index(row, column)] = kNan;
        }
    }
    const HeightMap whole = withInvalidPixelsFilled(map);
    for (int row = 2; row < 9; ++row) {
        for (int column = 3; column < 9; ++column) {
            EXPECT_GE(whole.at(row, column), 2.0);
            EXPECT_LE(whole.at(row, column), 9.0);
        }
    }
    EXPECT_LT(whole.at(5, 3), whole.at(5, 8));
}

TEST(InvalidPixels, OneKnownPixelFillsTheMap) {
    HeightMap map = rampMap();
    std::ranges::fill(map.heights, std::numeric_limits<double>::infinity());
    map.heights[map.index(9, 0)] = 5.0_nm;
    const HeightMap whole = withInvalidPixelsFilled(map);
    for (const double height : whole.heights) {
        EXPECT_DOUBLE_EQ(height, 5.0_nm);
    }
    EXPECT_EQ(std::ranges::count(whole.invalid, 1), 119);
}

TEST(InvalidPixels, AMaskedPixelWithAHeightKeepsBoth) {
    HeightMap map = rampMap();
    map.invalid.assign(map.heights.size(), 0);
    map.invalid[7] = 1;
    const HeightMap whole = withInvalidPixelsFilled(map);
    EXPECT_EQ(whole.heights, map.heights);
    EXPECT_EQ(whole.invalid, map.invalid);
}

TEST(InvalidPixels, AWholeMapIsLeftAsItIs) {
    const HeightMap whole = withInvalidPixelsFilled(rampMap());
    EXPECT_EQ(whole.heights, rampMap().heights);
    EXPECT_TRUE(whole.invalid.empty());
}

TEST(InvalidPixels, AMapWithoutAnyHeightIsRefused) {
    HeightMap map = rampMap();
    std::ranges::fill(map.heights, kNan);
    EXPECT_THROW((void)withInvalidPixelsFilled(map), Error);
}

}  // namespace
}  // namespace asperity
