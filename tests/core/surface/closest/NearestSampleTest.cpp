#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/ClosestPointTracker.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::mapOf;

/// Half as large again along y as along x.
constexpr ScanSize kOblongScan{.columns = 40, .rows = 20, .sizeX = 80.0_nm, .sizeY = 60.0_nm};

TEST(NearestSample, OnASlopeIsBesideTheClosestPoint) {
    const BSplineSurface slope = fitSurface(mapOf(
        kOblongScan, [](int row, int column) { return (1.5 * column - 0.5 * row) * 1.0_nm; }));
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Vector3 query(random.uniform(30.0, 50.0) * 1.0_nm,
                            random.uniform(20.0, 40.0) * 1.0_nm,
                            random.uniform(0.0, 50.0) * 1.0_nm);
        const ClosestPoint closest = closestPoint(slope, query, {});
        const auto position = nearestSample(slope, query, std::abs(closest.distance) + 3.0_nm);
        ASSERT_TRUE(position);
        EXPECT_LE(std::abs(position->x() - closest.point.x()), 2.0_nm);
        EXPECT_LE(std::abs(position->y() - closest.point.y()), 3.0_nm);
    }
}

TEST(NearestSample, IsTheSpikeBesideTheTip) {
    for (const int column : {0, 5, 20, 33, 39}) {
        const BSplineSurface spike = fitSurface(mapOf(kOblongScan, [&](int row, int at) {
            return row == 9 && at == column ? 30.0_nm : 0.0;
        }));
        const Vector2 peak((column + 0.5) * 2.0_nm, 10.5 * 3.0_nm);
        for (const double away : {-8.0_nm, 8.0_nm}) {
            const auto position =
                nearestSample(spike, Vector3(peak.x() + away, peak.y(), 28.0_nm), 25.0_nm);
            ASSERT_TRUE(position);
            EXPECT_LE((*position - peak).norm(), 2.1_nm) << column << " from " << away;
        }
    }
}

TEST(NearestSample, IsNoneBeyondReachAndOnMapsTooNarrow) {
    const auto level = [](int, int) { return 1.0_nm; };
    const BSplineSurface wide = fitSurface(mapOf(kOblongScan, level));
    EXPECT_FALSE(nearestSample(wide, {-20.0_nm, 30.0_nm, 5.0_nm}, 10.0_nm));
    EXPECT_FALSE(nearestSample(wide, {40.0_nm, 80.0_nm, 5.0_nm}, 10.0_nm));
    EXPECT_FALSE(nearestSample(wide, Vector3::Constant(1e90), 1.0_nm));
    EXPECT_TRUE(
        nearestSample(wide, {-20.0_nm, 30.0_nm, 5.0_nm}, std::numeric_limits<double>::infinity()));
    EXPECT_TRUE(nearestSample(wide, {40.0_nm, 30.0_nm, 1e90}, 1e91));
    const BSplineSurface narrow =
        fitSurface(mapOf({.columns = 7, .rows = 20, .sizeX = 14.0_nm, .sizeY = 60.0_nm}, level));
    EXPECT_FALSE(nearestSample(narrow, {5.0_nm, 30.0_nm, 5.0_nm}, 10.0_nm));
}

}  // namespace
}  // namespace asperity
