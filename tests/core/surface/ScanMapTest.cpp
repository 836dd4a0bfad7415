#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/HeightMap.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

using test::kNan;

/// Hills of 8 nm from top to bottom on a slope of 0.1, 3 um above zero, with a hole.
HeightMap highSlope() {
    HeightMap map =
        sampledMap({.columns = 60, .rows = 45, .sizeX = 480.0_nm, .sizeY = 450.0_nm},
                   EggBox{.amplitude = 4.0_nm, .periodX = 90.0_nm, .periodY = 130.0_nm});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] += 3.0_um + 0.1 * column * map.pitchX;
        }
    }
    map.heights[map.index(20, 30)] = kNan;
    map.heights[map.index(20, 31)] = std::numeric_limits<double>::infinity();
    return map;
}

/// Half of the heights' range, 56 nm, in single precision.
constexpr double kRounding = 0x1p-24 * 28.0_nm;

TEST(ScanMap, LosesNoDigitsToTheHeightAboveZero) {
    const HeightMap map = highSlope();
    const ScanMap scan = test::singlePrecision(map);
    EXPECT_EQ(scan.columns, map.columns);
    EXPECT_EQ(scan.rows, map.rows);
    EXPECT_EQ(scan.pitchX, map.pitchX);
    EXPECT_EQ(scan.pitchY, map.pitchY);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (isFiniteHeight(map.at(row, column))) {
                ASSERT_NEAR(scan.datum + scan.at(row, column), map.at(row, column), kRounding);
            } else {
                ASSERT_FALSE(isFiniteHeight(scan.at(row, column)));
            }
        }
    }
}

TEST(ScanMap, IsLeveledLikeAMapInDoublePrecision) {
    const HeightMap map = highSlope();
    const ScanMap scan = test::singlePrecision(map);
    EXPECT_NEAR(fitPlane(scan).slopeX, fitPlane(map).slopeX, 3.0 * kRounding / map.sizeX());
    EXPECT_NEAR(fitPlane(scan).mean, fitPlane(map).mean, kRounding);
    EXPECT_EQ(fitPlane(scan).centerX, fitPlane(map).centerX);
    const LevelPoints points{Vector2(60.0_nm, 60.0_nm), Vector2(400.0_nm, 70.0_nm),
                             Vector2(200.0_nm, 380.0_nm)};
    std::vector<LevelingSteps> lists{{}, {LevelingStep::Plane, LevelingStep::Zero}};
    for (const LevelingStep step : kValues<LevelingStep>) {
        lists.push_back({step});
    }
    for (const LevelingSteps& steps : lists) {
        SCOPED_TRACE(textOf(steps));
        const HeightMap exact = leveled(map, steps, points);
        const ScanMap level = leveled(scan, steps, points);
        const bool keepsDatum = steps.empty() || steps.front() == LevelingStep::Scars ||
                                steps.front() == LevelingStep::MedianOfDifferences;
        // The weights of facets depend on slopes between two pixels, which rounding changes most.
        const bool isFacet = !steps.empty() && steps.front() == LevelingStep::Facet;
        const double tolerance = (isFacet ? 10.0 : 3.0) * kRounding;
        EXPECT_EQ(level.datum, keepsDatum ? scan.datum : 0.0);
        EXPECT_EQ(level.invalid, exact.invalid);
        for (std::size_t i = 0; i < exact.heights.size(); ++i) {
            if (isFiniteHeight(exact.heights[i])) {
                ASSERT_NEAR(level.datum + static_cast<double>(level.heights[i]), exact.heights[i],
                            tolerance);
            }
        }
    }
}

TEST(ScanMap, HolesAreFilledAsInDoublePrecision) {
    const HeightMap exact = withInvalidPixelsFilled(highSlope());
    const ScanMap filled = withInvalidPixelsFilled(test::singlePrecision(highSlope()));
    EXPECT_EQ(filled.invalid, exact.invalid);
    EXPECT_NEAR(filled.datum + filled.at(20, 30), exact.at(20, 30), 2.0 * kRounding);
    EXPECT_NEAR(filled.datum + filled.at(20, 31), exact.at(20, 31), 2.0 * kRounding);
}

TEST(ScanMap, WithoutAnyHeightIsRefusedByTheFit) {
    HeightMap map = highSlope();
    map.heights.assign(map.heights.size(), kNan);
    EXPECT_THROW((void)fitSurface(map), Error);
    EXPECT_THROW((void)fitSurface(HeightMap{}), Error);
    EXPECT_THROW((void)fitSurface(ScanMap{}), Error);
}

}  // namespace
}  // namespace asperity
