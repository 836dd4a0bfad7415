#include "core/Units.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(CertaintyMap, KnowsPixelsByTheirPositionInTheWorld) {
    const HeightMap map = flatMap({.columns = 3, .rows = 2, .sizeX = 3.0_nm, .sizeY = 4.0_nm});
    const CertaintyMap certainty(map, {1, 1, 0, 1, 0, 1});
    EXPECT_TRUE(certainty.isKnown());
    EXPECT_FALSE(certainty.isUncertain(1.5_nm, 3.0_nm)) << "top row";
    EXPECT_TRUE(certainty.isUncertain(1.5_nm, 1.0_nm)) << "bottom row";
    EXPECT_TRUE(certainty.isUncertain(2.5_nm, 3.9_nm));
    EXPECT_DOUBLE_EQ(certainty.certainShare(), 4.0 / 6.0);
}

TEST(CertaintyMap, TakesPositionsOutsideForTheNearestInside) {
    const HeightMap map = flatMap({.columns = 2, .rows = 2, .sizeX = 2.0_nm, .sizeY = 2.0_nm});
    const CertaintyMap certainty(map, {1, 0, 1, 1});
    EXPECT_TRUE(certainty.isUncertain(2.0_nm, 2.0_nm)) << "the corner itself";
    EXPECT_TRUE(certainty.isUncertain(1.0, 1.0));
    EXPECT_FALSE(certainty.isUncertain(-1.0, 1.0));
    EXPECT_FALSE(certainty.isUncertain(-1.0, -1.0));
    EXPECT_FALSE(certainty.isUncertain(std::numeric_limits<double>::quiet_NaN(), 0.0));
}

TEST(CertaintyMap, OfAnUnknownTipCallsNothingUncertain) {
    const CertaintyMap certainty;
    EXPECT_FALSE(certainty.isKnown());
    EXPECT_FALSE(certainty.isUncertain(1.0_nm, 1.0_nm));
    EXPECT_EQ(certainty.certainShare(), 0.0);
}

}  // namespace
}  // namespace asperity
