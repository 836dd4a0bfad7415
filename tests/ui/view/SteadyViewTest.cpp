#include "core/Units.h"
#include "ui/view/DrapedGrid.h"
#include "ui/view/ForceScale.h"
#include "ui/view/Magnification.h"
#include "ui/view/SurfaceColors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {

namespace {

constexpr double kTipRadius = 15.0_nm;
constexpr double kRoom = 40.0_nm;

}  // namespace

TEST(Magnification, MakesSmallDisplacementsPlainAndLeavesLargeOnesAlone) {
    EXPECT_GE(Magnification().fit(0.3_nm, -0.3_nm, kTipRadius) * 0.3_nm, 3.0_nm);
    EXPECT_EQ(Magnification().fit(20.0_nm, -20.0_nm, kTipRadius), 1.0);
}

TEST(Magnification, IsRoundAndDoesNotFlicker) {
    Magnification magnification;
    int changes = 0;
    double last = magnification.fit(0.6_nm, -0.6_nm, kTipRadius);
    for (int i = 0; i < 200; ++i) {
        const double now = magnification.fit((0.6 + 0.1 * (i % 2)) * 1e-9, -0.6_nm, kTipRadius);
        changes += now != last ? 1 : 0;
        last = now;
    }
    EXPECT_LE(changes, 1);
    const double mantissa = last / std::pow(10.0, std::floor(std::log10(last)));
    EXPECT_TRUE(mantissa == 1.0 || mantissa == 2.0 || mantissa == 5.0) << last;
}

TEST(Magnification, KeepsAFarTipInThePicture) {
    Magnification magnification;
    for (int step = 0; step < 22; ++step) {
        const double gap = 60.0_nm * std::pow(0.8, step);
        const double factor = magnification.fit(0.0, gap, kTipRadius);
        EXPECT_TRUE(factor == 1.0 || factor * gap < 3.0 * kTipRadius) << gap << " " << factor;
    }
}

TEST(Magnification, CanBeFixed) {
    Magnification magnification;
    magnification.fix(3.0);
    EXPECT_EQ(magnification.fit(0.1_nm, 0.0, kTipRadius), 3.0);
    magnification.fix(std::nullopt);
    EXPECT_NE(magnification.fit(0.1_nm, 0.0, kTipRadius), 3.0);
}

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
