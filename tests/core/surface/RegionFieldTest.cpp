#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/PixelField.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Two rows of three pixels of 10 nm, from (20 nm, 30 nm) on; the last pixel of the top row holds
/// no value.
RegionField field() {
    return {{20.0_nm, 30.0_nm, 30.0_nm, 20.0_nm}, 3, 2, {1.0F, 2.0F, kNone, 4.0F, 5.0F, 6.0F}, "N"};
}

TEST(RegionField, APositionHasTheValueOfItsPixel) {
    EXPECT_EQ(field().at(20.1_nm, 49.9_nm), 1.0) << "the top row is the far one";
    EXPECT_EQ(field().at(29.9_nm, 40.1_nm), 1.0);
    EXPECT_EQ(field().at(30.1_nm, 45.0_nm), 2.0);
    EXPECT_EQ(field().at(25.0_nm, 39.9_nm), 4.0);
    EXPECT_EQ(field().at(49.9_nm, 30.1_nm), 6.0);
    EXPECT_EQ(field().unit(), "N");
}

TEST(RegionField, APixelWithoutValueIsCoveredAndBesideTheRegionNothingIs) {
    EXPECT_TRUE(field().covers(45.0_nm, 45.0_nm));
    EXPECT_TRUE(std::isnan(field().at(45.0_nm, 45.0_nm)));
    EXPECT_TRUE(field().hasGaps());
    EXPECT_FALSE(field().covers(19.9_nm, 35.0_nm));
    EXPECT_FALSE(field().covers(35.0_nm, 50.1_nm));
    EXPECT_TRUE(std::isnan(field().at(19.9_nm, 35.0_nm)));
    EXPECT_FALSE(RegionField({0.0, 0.0, 1.0, 1.0}, 1, 1, {0.0F}, "N").hasGaps());
}

TEST(RegionField, NeedsOneValueForEachPixel) {
    EXPECT_THROW(RegionField({0.0, 0.0, 1.0, 1.0}, 2, 2, {1.0F}, "N"), Error);
    EXPECT_THROW(RegionField({0.0, 0.0, 0.0, 1.0}, 1, 1, {1.0F}, "N"), Error);
}

}  // namespace
}  // namespace asperity
