#include "core/surface/PixelField.h"

#include "core/Error.h"
#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

/// 4 x 3 pixels of 2 nm x 3 nm, values 10 row + column.
HeightMap numbered() {
    HeightMap map{.columns = 4, .rows = 3, .pitchX = 2.0_nm, .pitchY = 3.0_nm};
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights.push_back(10.0 * row + column);
        }
    }
    return map;
}

TEST(PixelField, HoldsThePixelsWhereTheyAreInTheWorldFrame) {
    const PixelField field(numbered(), "V");
    EXPECT_EQ(field.unit(), "V");
    EXPECT_NEAR(field.at(1.0_nm, 7.5_nm), 0.0, 1e-9) << "upper left";
    EXPECT_NEAR(field.at(7.0_nm, 7.5_nm), 3.0, 1e-9);
    EXPECT_NEAR(field.at(1.0_nm, 1.5_nm), 20.0, 1e-9) << "lower left: row 2";
    EXPECT_NEAR(field.at(4.0_nm, 6.0_nm), 6.5, 1e-6) << "between four pixels";
    EXPECT_NEAR(field.at(-5.0_nm, 99.0_nm), 0.0, 1e-9) << "beyond: the nearest";
    EXPECT_NEAR(field.at(99.0_nm, -5.0_nm), 23.0, 1e-9);
}

TEST(PixelField, IsNoNumberAroundAPixelWithoutOne) {
    HeightMap map = numbered();
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(1, 1)] = true;
    map.heights[map.index(0, 3)] = std::numeric_limits<double>::infinity();
    const PixelField field(map, "V");
    EXPECT_TRUE(std::isnan(field.at(3.0_nm, 4.5_nm)));
    EXPECT_TRUE(std::isnan(field.at(3.5_nm, 4.0_nm)));
    EXPECT_NEAR(field.at(5.0_nm, 4.5_nm), 12.0, 1e-9) << "the neighbor's own center";
    EXPECT_FALSE(std::isfinite(field.at(7.0_nm, 7.5_nm)));
}

TEST(PixelField, OfOnePixelIsConstantAndAnUnusableMapIsRefused) {
    const HeightMap one{
        .columns = 1, .rows = 1, .pitchX = 1.0_nm, .pitchY = 1.0_nm, .heights = {7.0}};
    EXPECT_EQ(PixelField(one, "").at(3.0, -1.0), 7.0);
    EXPECT_THROW(PixelField(HeightMap{}, ""), Error);
}

}  // namespace
}  // namespace asperity
