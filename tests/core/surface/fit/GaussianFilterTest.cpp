#include "core/surface/fit/GaussianFilter.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/ProgressRecorder.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

using test::kNan;

HeightMap plane(int columns, int rows) {
    HeightMap map = flatMap({.columns = columns, .rows = rows, .sizeX = 1.0_um, .sizeY = 1.0_um});
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights[map.index(row, column)] = 7.0_nm + column * 2.0_nm - row * 3.0_nm;
        }
    }
    return map;
}

TEST(GaussianFilter, LeavesAPlaneUnchangedUpToTheBorders) {
    for (const double sigma :
         {0.3, 1.0, 2.5, 40.0}) {  // the last reaches many times past 20 pixels
        const HeightMap map = plane(20, 11);
        const HeightMap smooth = smoothed(map, sigma);
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            ASSERT_NEAR(smooth.heights[i], map.heights[i], 1e-12 * 50.0_nm * (1.0 + sigma));
        }
    }
}

TEST(GaussianFilter, DampsAWaveByItsTransferFunction) {
    constexpr int kColumns = 400;
    constexpr double kSigma = 2.0;
    constexpr double kPeriod = 16.0;  // [pixel]
    HeightMap map = flatMap({.columns = kColumns, .rows = 60, .sizeX = 1.0_um, .sizeY = 1.0_um});
    const double wave = 2.0 * std::numbers::pi / kPeriod;
    for (int row = 0; row < 60; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            map.heights[map.index(row, column)] = std::sin(wave * column);
        }
    }
    const double damping = std::exp(-0.5 * kSigma * kSigma * wave * wave);
    const HeightMap smooth = smoothed(map, kSigma);
    for (int column = 20; column < kColumns - 20; ++column) {
        // 6e-7 of the kernel lies beyond 5 standard deviations
        ASSERT_NEAR(smooth.at(30, column), damping * map.at(30, column), 3e-6);
    }
}

TEST(GaussianFilter, SpreadsASpikeEvenlyWithoutLosingVolume) {
    HeightMap map = flatMap({.columns = 41, .rows = 41, .sizeX = 1.0_um, .sizeY = 1.0_um});
    map.heights[map.index(20, 20)] = 1.0;
    const HeightMap smooth = smoothed(map, 2.0);
    double sum = 0.0;
    for (const double height : smooth.heights) {
        sum += height;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(smooth.at(20, 20), 1.0 / (8.0 * std::numbers::pi), 1e-6);
    EXPECT_DOUBLE_EQ(smooth.at(17, 20), smooth.at(20, 23));
    EXPECT_NEAR(smooth.at(17, 20) / smooth.at(20, 20), std::exp(-9.0 / 8.0), 1e-9);
}

TEST(GaussianFilter, ZeroIsIdentityAndTinyWidthsAreNothing) {
    const HeightMap map = plane(6, 5);
    EXPECT_EQ(smoothed(map, 0.0).heights, map.heights);
    EXPECT_EQ(smoothed(map, 1e-300).heights, map.heights);
}

TEST(GaussianFilter, WorksOnLinesAndSinglePixels) {
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}}) {
        const HeightMap map = plane(columns, rows);
        const HeightMap smooth = smoothed(map, 3.0);
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            ASSERT_NEAR(smooth.heights[i], map.heights[i], 1e-19);
        }
    }
}

TEST(GaussianFilter, InSinglePrecisionIsTheSameButForRounding) {
    HeightMap map = plane(45, 38);  // no whole number of blocks
    map.heights[map.index(20, 21)] += 30.0_nm;
    const ScanMap scan = test::singlePrecision(map);
    const HeightMap exact = smoothed(map, Smoothing{.x = 2.0, .y = 0.7});
    const ScanMap smooth = smoothed(scan, Smoothing{.x = 2.0, .y = 0.7});
    const double largest = std::abs(static_cast<double>(*std::ranges::max_element(
        scan.heights, {}, [](float height) { return std::abs(height); })));
    for (std::size_t i = 0; i < exact.heights.size(); ++i) {
        ASSERT_NEAR(smooth.datum + static_cast<double>(smooth.heights[i]), exact.heights[i],
                    0x1p-22 * largest);
    }
}

TEST(GaussianFilter, TellsHowFarItIsAndCanBeCanceled) {
    const ScanMap map = test::singlePrecision(plane(900, 700));
    const Smoothing smoothing{.x = 1.0, .y = 1.0};
    test::ProgressRecorder whole(2.0);
    (void)smoothed(map, smoothing, &whole);
    EXPECT_GE(whole.fractions.size(), 20U);
    EXPECT_TRUE(std::ranges::is_sorted(whole.fractions));
    for (const double fraction : {0.2, 0.7}) {
        test::ProgressRecorder recorder(fraction);
        EXPECT_THROW((void)smoothed(map, smoothing, &recorder), Canceled);
        EXPECT_LT(recorder.fractions.back(), fraction + 0.1);
    }
}

TEST(GaussianFilter, RefusesWidthsAndHeightsThatAreNoNumbers) {
    HeightMap map = plane(4, 4);
    for (const double sigma : {-1.0, kNan, std::numeric_limits<double>::infinity(), 1e9}) {
        EXPECT_THROW((void)smoothed(map, sigma), Error);
    }
    map.heights[3] = kNan;
    EXPECT_THROW((void)smoothed(map, 1.0), Error);
    EXPECT_THROW((void)smoothed(HeightMap{}, 1.0), Error);
}

}  // namespace
}  // namespace asperity
