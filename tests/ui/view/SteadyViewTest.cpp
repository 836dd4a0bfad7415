#include "core/Units.h"
#include "ui/view/DrapedGrid.h"
#include "ui/view/ForceScale.h"
#include "ui/view/SurfaceColors.h"

#include <gtest/gtest.h>

namespace asperity {

namespace {

constexpr double kRoom = 40.0_nm;

}  // namespace

TEST(ForceScale, FitsTheForceIntoItsRoom) {
    for (const double force : {0.5e-9, 3e-9, 25e-9, 400e-9}) {
        const double length = ForceScale().fit(force, 1e-12, 0.0, kRoom) * force;
        EXPECT_LE(length, kRoom * (1.0 + 1e-9));
        EXPECT_GE(length, 0.2 * kRoom);
    }
}

TEST(ForceScale, KeepsItsScaleWhileTheForceVaries) {
    ForceScale scale;
    const double first = scale.fit(20e-9, 1e-10, 0.0, kRoom);
    EXPECT_EQ(scale.fit(9e-9, 1e-10, 0.03, kRoom), first);
    EXPECT_EQ(scale.fit(0.0, 1e-10, 0.06, kRoom), first) << "a moment without force";
}

TEST(ForceScale, ComesBackToSmallForcesAfterAWhile) {
    ForceScale scale;
    const double first = scale.fit(20e-9, 1e-11, 0.0, kRoom);
    EXPECT_GT(scale.fit(2e-9, 1e-11, 3.0, kRoom), first);
}

TEST(ForceScale, NeverDrawsNoiseLong) {
    ForceScale scale;
    for (int i = 0; i < 100; ++i) {
        const double noise = 1e-10 * (i % 3);
        EXPECT_LE(scale.fit(noise, 1e-10, 0.5 * i, kRoom) * noise, 0.25 * kRoom);
    }
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
