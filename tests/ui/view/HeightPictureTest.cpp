
#include "ui/view/ReliefImage.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/ColorMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace asperity::test {
namespace {

/// Rises along x from 0 to 1 nm.
HeightMap ramp(int columns, int rows) {
    HeightMap map{.columns = columns, .rows = rows, .pitchX = 1e-9, .pitchY = 1e-9, .heights = {}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights.push_back(1e-9 * column / (columns - 1));
        }
    }
    return map;
}

int difference(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
}

TEST(HeightPicture, HasAPixelForEachAndTheColorsOfHeights) {
    const QImage image = heightPicture(ramp(101, 20));
    EXPECT_EQ(image.size(), QSize(101, 20));
    const ColorTable colors(ColorMap::Standard, 0.0, 1e-9);
    EXPECT_LT(difference(image.pixelColor(0, 3), toQColor(colors.of(0.0))), 12);
    EXPECT_LT(difference(image.pixelColor(50, 3), toQColor(colors.of(0.5e-9))), 12);
    EXPECT_LT(difference(image.pixelColor(100, 3), toQColor(colors.of(1e-9))), 12);
}

TEST(HeightPicture, IsSmallOfALargeOne) {
    EXPECT_EQ(heightPicture(ramp(2048, 512)).size(), QSize(512, 128));
    EXPECT_EQ(heightPicture(ramp(5000, 2)).size(), QSize(512, 1));
}

TEST(HeightPicture, AnOutlierDoesNotLeaveTheRestInOneColor) {
    HeightMap map = ramp(101, 20);
    map.heights[5] = 1e-3;
    const QImage image = heightPicture(map);
    EXPECT_GT(difference(image.pixelColor(0, 3), image.pixelColor(100, 3)), 150);
}

TEST(HeightPicture, WhatHoldsNoDataIsStriped) {
    HeightMap map = ramp(50, 50);
    map.heights[map.index(10, 20)] = std::nan("");
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(10, 20)] = true;
    EXPECT_EQ(heightPicture(map).pixelColor(20, 10), hatched(10, 20));
    map.heights.assign(map.heights.size(), std::nan(""));
    map.invalid.assign(map.heights.size(), true);
    EXPECT_EQ(heightPicture(map).pixelColor(0, 0), hatched(0, 0)) << "all of it";
}

}  // namespace
}  // namespace asperity::test
