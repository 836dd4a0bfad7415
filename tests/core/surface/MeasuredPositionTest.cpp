#include "core/Units.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/fit/BSplineFit.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// 4 x 4 pixels of 1 nm with data in the leftmost column alone, in none, or in all.
BSplineSurface surfaceWith(int validColumns) {
    HeightMap map{.columns = 4,
                  .rows = 4,
                  .pitchX = 1.0_nm,
                  .pitchY = 1.0_nm,
                  .heights = std::vector<double>(16, 0.0),
                  .invalid = {}};
    map.invalid.assign(16, true);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < validColumns; ++column) {
            map.invalid[map.index(row, column)] = false;
        }
    }
    return fitSurface(map);
}

TEST(MeasuredPosition, IsThePositionItselfWhereThereAreData) {
    const Vector2 position(0.3_nm, 2.2_nm);
    EXPECT_EQ(nearestMeasured(surfaceWith(4), position), position);
    EXPECT_EQ(nearestMeasured(surfaceWith(1), position), position);
}

TEST(MeasuredPosition, IsTheNearestPixelWithDataElsewhere) {
    const Vector2 found = nearestMeasured(surfaceWith(1), Vector2(2.6_nm, 2.2_nm));
    EXPECT_NEAR(found.x(), 0.5_nm, 1e-20);
    EXPECT_NEAR(found.y(), 2.5_nm, 1e-20);
}

}  // namespace
}  // namespace asperity
