#include "core/map/MapComparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

const MapPlan kMeasuredPlan{.grid = {.columns = 6, .rows = 4},
                            .region = {20e-9, 10e-9, 80e-9, 50e-9},
                            .setpoint = 1e-9,
                            .quantities = {MapQuantity::Height}};
constexpr MapRegion kScan{0.0, 0.0, 100e-9, 60e-9};

double tilt(double x, double y) { return 3e-9 + 0.2 * x - 0.7 * y; }

/// A tilted plane over an area.
HeightMap planeOver(const MapRegion& area, int columns, int rows) {
    HeightMap map{.columns = columns,
                  .rows = rows,
                  .pitchX = (area.right - area.left) / columns,
                  .pitchY = (area.top - area.bottom) / rows};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights.push_back(
                tilt(area.left + (column + 0.5) * map.pitchX, area.top - (row + 0.5) * map.pitchY));
        }
    }
    return map;
}

TEST(MeasuredMap, OnTheSamePixelsIsKeptToTheBit) {
    const HeightMap map = planeOver(kMeasuredPlan.region, 6, 4);
    EXPECT_EQ(valuesAt(kMeasuredPlan, map, kMeasuredPlan.region), map.heights);
    const HeightMap whole = planeOver(kScan, 10, 6);
    const std::vector<double> part = valuesAt(kMeasuredPlan, whole, kScan);
    EXPECT_EQ(part[0], whole.at(1, 2));
    EXPECT_EQ(part[23], whole.at(4, 7));
}

TEST(MeasuredMap, OnOtherPixelsIsLinearBetweenThem) {
    for (const auto& [columns, rows] : {std::pair(50, 31), std::pair(7, 9)}) {
        const std::vector<double> values =
            valuesAt(kMeasuredPlan, planeOver(kScan, columns, rows), kScan);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 6; ++column) {
                const Vector2 position = kMeasuredPlan.position(row, column);
                EXPECT_NEAR(values[static_cast<std::size_t>(6 * row + column)],
                            tilt(position.x(), position.y()), 1e-21);
            }
        }
    }
}

TEST(MeasuredMap, BeyondItsOutermostPixelsIsConstant) {
    const HeightMap map = planeOver(kMeasuredPlan.region, 3, 2);
    const std::vector<double> values = valuesAt(kMeasuredPlan, map, kMeasuredPlan.region);
    EXPECT_EQ(values[0], map.at(0, 0));
    EXPECT_EQ(values[23], map.at(1, 2));
}

TEST(MeasuredMap, HasNoDataWhereANeighborHasNone) {
    HeightMap same = planeOver(kMeasuredPlan.region, 6, 4);
    same.heights[8] = std::nan("");  // row 1, column 2
    const std::vector<double> one = valuesAt(kMeasuredPlan, same, kMeasuredPlan.region);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(std::isnan(one[i]), i == 8) << i;
    }
    HeightMap coarse = planeOver(kMeasuredPlan.region, 3, 2);
    coarse.invalid = PixelMask(6, false);
    coarse.invalid[0] = true;
    const std::vector<double> four = valuesAt(kMeasuredPlan, coarse, kMeasuredPlan.region);
    for (std::size_t i = 0; i < four.size(); ++i) {
        EXPECT_EQ(std::isnan(four[i]), i % 6 < 3 && i < 18) << i;
    }
}

TEST(MeasuredMap, ShowsTheRegionOrTheScan) {
    EXPECT_EQ(measuredArea(60e-9, 40e-9, kMeasuredPlan, kScan), kMeasuredPlan.region);
    EXPECT_EQ(measuredArea(60.9e-9, 39.4e-9, kMeasuredPlan, kScan), kMeasuredPlan.region);
    EXPECT_EQ(measuredArea(100e-9, 60e-9, kMeasuredPlan, kScan), kScan);
    EXPECT_EQ(measuredArea(60e-9, 60e-9, kMeasuredPlan, kScan), std::nullopt);
    MapPlan nearlyAll = kMeasuredPlan;
    nearlyAll.region = {1e-9, 0.6e-9, 100e-9, 60e-9};
    EXPECT_EQ(measuredArea(100e-9, 60e-9, nearlyAll, kScan), kScan) << "the better fit";
    EXPECT_EQ(measuredArea(100e-9, 58e-9, kMeasuredPlan, kScan), std::nullopt);
}

}  // namespace
}  // namespace asperity
