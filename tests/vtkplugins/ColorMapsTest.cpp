#include "vtkplugins/pictures/ColorMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace asperity {
namespace {

int difference(const Color& one, const Color& other) {
    return std::abs(one.red - other.red) + std::abs(one.green - other.green) +
           std::abs(one.blue - other.blue);
}

TEST(ColorMaps, GrowLighterFromTheLowestValueToTheHighest) {
    for (const ColorMap map : kValues<ColorMap>) {
        if (map == ColorMap::Diverging) {
            continue;
        }
        const ColorTable table(map, 0.0, 1.0);
        constexpr int kSteps = 200;
        double before = lightnessOf(table.of(0.0));
        for (int step = 1; step <= kSteps; ++step) {
            const double lightness = lightnessOf(table.of(step / double(kSteps)));
            EXPECT_GT(lightness, before - 0.25) << nameOf(map) << " at " << step;  // 8 bits
            before = std::max(before, lightness);
        }
        EXPECT_GT(before - lightnessOf(table.of(0.0)), 60.0) << nameOf(map);
    }
}

TEST(ColorMaps, TheDivergingOneIsLightestAtZeroAndDarkAtBothEnds) {
    const ColorTable table(ColorMap::Diverging, -2.0, 2.0);
    const double zero = lightnessOf(table.of(0.0));
    double low = zero;
    double high = zero;
    for (int step = 1; step <= 50; ++step) {
        const double below = lightnessOf(table.of(-step / 25.0));
        const double above = lightnessOf(table.of(step / 25.0));
        EXPECT_LT(below, low + 0.25) << step;
        EXPECT_LT(above, high + 0.25) << step;
        low = below;
        high = above;
    }
    EXPECT_LT(low, 50.0);
    EXPECT_LT(high, 50.0);
    EXPECT_GT(difference(table.of(-2.0), table.of(2.0)), 200) << "the signs look different";
}

TEST(ColorMaps, HaveTheColorsOfTheirSources) {
    EXPECT_EQ(difference(ColorTable(ColorMap::Gray, 0.0, 1.0).of(0.5), {128, 128, 128}), 0);
    const ColorTable gold(ColorMap::Gold, 0.0, 1.0);
    EXPECT_LE(difference(gold.of(0.344671), {168, 40, 15}), 6);
    EXPECT_LE(difference(gold.of(0.687075), {243, 194, 93}), 6);
    const ColorTable viridis(ColorMap::Viridis, 0.0, 1.0);
    EXPECT_LE(difference(viridis.of(0.0), {68, 1, 84}), 1);
    EXPECT_LE(difference(viridis.of(1.0), {253, 231, 37}), 1);
    EXPECT_LE(difference(viridis.of(0.5), {33, 145, 140}), 3);
    EXPECT_LE(difference(ColorTable(ColorMap::Cividis, 0.0, 1.0).of(0.0), {0, 34, 78}), 1);
}

TEST(ColorMaps, ClipBeyondTheRange) {
    const ColorTable table(ColorMap::Viridis, -1e-9, 3e-9);
    EXPECT_EQ(difference(table.of(-5e-9), table.of(-1e-9)), 0);
    EXPECT_EQ(difference(table.of(1.0), table.of(3e-9)), 0);
    EXPECT_GT(difference(table.of(-1e-9), table.of(3e-9)), 200);
}

TEST(ColorMaps, LightnessIsThatOfCie) {
    EXPECT_NEAR(lightnessOf({255, 255, 255}), 100.0, 1e-3);
    EXPECT_NEAR(lightnessOf({0, 0, 0}), 0.0, 1e-12);
    EXPECT_NEAR(lightnessOf({119, 119, 119}), 50.03, 0.02);
    EXPECT_NEAR(lightnessOf({255, 0, 0}), 53.24, 0.02);
}

}  // namespace
}  // namespace asperity
