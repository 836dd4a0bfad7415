#include "core/Units.h"
#include "ui/view/DrapedGrid.h"
#include "ui/view/ForceScale.h"
#include "ui/view/SurfaceColors.h"

#include <gtest/gtest.h>

namespace asperity {

namespace {

constexpr double kRoom = 40.0_nm;

}  // namespace

TEST(ForceScale, ALargerForceHasALongerArrowThatFitsItsRoom) {
    double before = 0.0;
    for (const double force : {0.05e-9, 0.5e-9, 3e-9, 5e-9, 17e-9, 25e-9, 400e-9}) {
        const double length = arrowLength(force, 5e-9, kRoom);
        EXPECT_GT(length, before);
        EXPECT_LE(length, kRoom);
        before = length;
    }
    EXPECT_DOUBLE_EQ(arrowLength(5e-9, 5e-9, kRoom), 0.5 * kRoom);
    EXPECT_NEAR(arrowLength(1e-12, 5e-9, kRoom), kRoom * 2e-4, 1e-3 * kRoom * 2e-4);
}

TEST(SurfaceColors, ShowHeightAtRestAndDisplacementWhereItIsLarge) {
    SurfaceColors colors;
    EXPECT_TRUE(colors.fitHeights(0.0, 10.0_nm));
    EXPECT_TRUE(colors.fitDisplacement(1.5_nm));
    const Color rest = colors.at(5.0_nm);
    const Color pushed = colors.at(5.0_nm, 1.5_nm);
    const Color pulled = colors.at(5.0_nm, -1.5_nm);
    EXPECT_GT(pushed.blue, pushed.red + 60) << "pushed in: blue";
    EXPECT_GT(pulled.red, pulled.blue + 60) << "pulled out: orange";
    EXPECT_GT(rest.green, rest.red);
    const Color hardly = colors.at(5.0_nm, 0.01_nm);
    EXPECT_EQ(hardly.green, rest.green);
}

TEST(SurfaceColors, RangesAreSteadyAndHoldTheValues) {
    SurfaceColors colors;
    colors.fitDisplacement(1.5_nm);
    EXPECT_FALSE(colors.fitDisplacement(1.3_nm));
    EXPECT_TRUE(colors.fitDisplacement(4.0_nm));
    const ColorScale scale = colors.displacementScale();
    EXPECT_GE(scale.high, 4.0_nm);
    EXPECT_DOUBLE_EQ(scale.low, -scale.high);
    EXPECT_EQ(scale.unit, "m");
    ASSERT_GE(scale.colors.size(), 2U);
    EXPECT_GT(scale.colors.front().red(), scale.colors.front().blue());
    EXPECT_GT(scale.colors.back().blue(), scale.colors.back().red());
    colors.fitHeights(-3.0_nm, 8.0_nm);
    EXPECT_LE(colors.heightScale().low, -3.0_nm);
    EXPECT_GE(colors.heightScale().high, 8.0_nm);
}

TEST(DrapedGrid, LinesLieAtRoundPlacesBetweenTheEdges) {
    const double spacing = gridSpacing(80.0_nm);
    EXPECT_DOUBLE_EQ(spacing, 2.0_nm);
    const std::vector<double> places = gridPlaces(-4.0_nm, 5.0_nm, spacing);
    ASSERT_EQ(places.size(), 4U);
    EXPECT_NEAR(places.front(), -2.0_nm, 1e-20);
    EXPECT_NEAR(places.back(), 4.0_nm, 1e-20);
}

}  // namespace asperity
