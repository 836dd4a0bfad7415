
#include "core/surface/HeightMap.h"
#include "core/surface/fit/BSplineFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace asperity {
namespace {

/// Soft hills of 5 nm on 200 nm; no data in the lower left quarter.
HeightMap hillsWithGap(int columns, int rows) {
    HeightMap map;
    map.columns = columns;
    map.rows = rows;
    map.pitchX = 1e-9;
    map.pitchY = 2e-9;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights.push_back(5e-9 * std::sin(column * 1e-9 / 32e-9) *
                                  std::cos(row * 2e-9 / 32e-9));
            map.invalid.push_back(row >= rows / 2 && column < columns / 2 ? 1 : 0);
        }
    }
    return map;
}

TEST(CoarserSurface, IsTheSameLandWithFewerPixels) {
    const BSplineSurface fine = fitSurface(hillsWithGap(400, 160));
    const BSplineSurface coarse = coarserSurface(fine, 100);
    EXPECT_EQ(coarse.grid().columns, 100);
    EXPECT_EQ(coarse.grid().rows, 100);
    EXPECT_DOUBLE_EQ(coarse.sizeX(), fine.sizeX());
    EXPECT_DOUBLE_EQ(coarse.sizeY(), fine.sizeY());
    for (const double x : {41.3e-9, 130.9e-9, 333.2e-9}) {
        for (const double y : {55.0e-9, 101.7e-9, 290.1e-9}) {
            EXPECT_NEAR(coarse.at(x, y).height, fine.at(x, y).height, 2e-12);
            EXPECT_EQ(coarse.isMeasured(x, y), fine.isMeasured(x, y));
        }
    }
}

TEST(CoarserSurface, StaysAsItIsWhereItHasNoMorePixels) {
    const BSplineSurface fine = fitSurface(hillsWithGap(60, 40));
    EXPECT_TRUE(coarserSurface(fine, 60).grid().controlHeights == fine.grid().controlHeights);
}

}  // namespace
}  // namespace asperity
