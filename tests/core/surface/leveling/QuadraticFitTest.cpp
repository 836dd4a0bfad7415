#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/leveling/PlaneFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

/// z = 20 nm + 0.1 X - 0.2 Y + (3e4 X^2 + 1e4 X Y - 5e4 Y^2) / m, from the center of the scan.
struct Bowl {
    static constexpr double kSizeX = 900e-9;
    static constexpr double kSizeY = 800e-9;

    static double height(double x, double y) {
        const double fromCenterX = x - 0.5 * kSizeX;
        const double fromCenterY = y - 0.5 * kSizeY;
        return 20e-9 + 0.1 * fromCenterX - 0.2 * fromCenterY + 3e4 * fromCenterX * fromCenterX +
               1e4 * fromCenterX * fromCenterY - 5e4 * fromCenterY * fromCenterY;
    }
};

HeightMap bowl() {
    return sampledMap({.columns = 45, .rows = 32, .sizeX = Bowl::kSizeX, .sizeY = Bowl::kSizeY},
                      Bowl{});
}

TEST(QuadraticFit, FindsHeightSlopesAndBendsAtTheCenter) {
    const QuadraticFit fit(bowl());
    EXPECT_NEAR(fit.height(), 20e-9, 1e-20);
    EXPECT_NEAR(fit.slopeX(), 0.1, 1e-13);
    EXPECT_NEAR(fit.slopeY(), -0.2, 1e-13);
    EXPECT_NEAR(fit.bendX(), 6e4, 1e-7);
    EXPECT_NEAR(fit.bendY(), -1e5, 1e-7);
    EXPECT_NEAR(fit.twist(), 1e4, 1e-7);
}

TEST(QuadraticFit, LeavesNothingOfAQuadraticAndLeavesOutPixelsWithoutData) {
    HeightMap map = bowl();
    map.heights[map.index(3, 4)] = std::numeric_limits<double>::quiet_NaN();
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(8, 9)] = true;
    map.heights[map.index(8, 9)] = 1.0;  // [m]
    const LeveledMap<HeightMap> level = leveledInSteps(map, {LevelingStep::Quadratic});
    for (std::size_t i = 0; i < level.map.heights.size(); ++i) {
        if (i != map.index(3, 4) && i != map.index(8, 9)) {
            ASSERT_NEAR(level.map.heights[i], 0.0, 1e-20);
        }
    }
    EXPECT_NEAR(level.removed.front().plane.slopeY, -0.2, 1e-12);
    EXPECT_NEAR(level.removed.front().bendX, 6e4, 1e-6);
}

/// The residual of a least-squares fit has no part along any of the terms.
TEST(QuadraticFit, IsTheLeastSquaresOne) {
    HeightMap map = bowl();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] +=
                5e-9 * std::sin(0.4 * column) * std::cos(0.9 * row) + 2e-9 * std::cos(0.1 * column);
        }
    }
    const HeightMap rest = leveled(map, {LevelingStep::Quadratic});
    double sums[6] = {};
    double square = 0.0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double u = 2.0 * (column + 0.5) / map.columns - 1.0;
            const double v = 1.0 - 2.0 * (row + 0.5) / map.rows;
            const double height = rest.at(row, column);
            const double terms[6] = {1.0, u, v, u * u, u * v, v * v};
            for (int i = 0; i < 6; ++i) {
                sums[i] += terms[i] * height;
            }
            square += height * height;
        }
    }
    EXPECT_GT(square, 1e-15);
    for (const double sum : sums) {
        EXPECT_NEAR(sum, 0.0, 1e-19);  // heights of 1e-7 m, rounded in 1440 pixels
    }
}

TEST(QuadraticFit, OfSinglePrecisionAgreesWithDouble) {
    const QuadraticFit coarse(test::singlePrecision(bowl()));
    EXPECT_NEAR(coarse.slopeX(), 0.1, 1e-7);
    EXPECT_NEAR(coarse.bendY(), -1e5, 1.0);
}

TEST(QuadraticFit, OfTooFewPixelsIsTheSmallestOne) {
    HeightMap line = flatMap({.columns = 4, .rows = 1, .sizeX = 40.0_nm, .sizeY = 10.0_nm});
    line.heights = {1e-9, 3e-9, 1e-9, 3e-9};
    const QuadraticFit fit(line);
    EXPECT_EQ(fit.slopeY(), 0.0);
    EXPECT_EQ(fit.bendY(), 0.0);
    EXPECT_TRUE(std::isfinite(fit.at(0, 3)));
    EXPECT_THROW((void)QuadraticFit(HeightMap{}), Error);
}

}  // namespace
}  // namespace asperity
