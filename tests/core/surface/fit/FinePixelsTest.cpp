#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace asperity {
namespace {

constexpr double kHillsSize = 51.2_nm;

/// Hills whose period is the whole scan: their curvature is 7.5e7 1/m at most along an axis.
EggBox scanWideHills() {
    return {.amplitude = 5.0_nm,
            .periodX = kHillsSize,
            .periodY = kHillsSize,
            .phaseX = 0.3,
            .phaseY = 0.5};
}

/// The hills, far from zero as the heights of a file are.
HeightMap mapOf(int pixels, double offset) {
    HeightMap map =
        sampledMap({.columns = pixels, .rows = pixels, .sizeX = kHillsSize, .sizeY = kHillsSize},
                   scanWideHills());
    for (double& height : map.heights) {
        height += offset;
    }
    return map;
}

/// Largest error of a second derivative in the middle half of the scan, at and between pixels.
double curvatureError(const BSplineSurface& surface) {
    constexpr int kPositions = 157;
    double worst = 0.0;
    for (int i = 0; i < kPositions; ++i) {
        const double x = kHillsSize * (0.25 + 0.5 * i / kPositions);
        for (int j = 0; j < kPositions; ++j) {
            const double y = kHillsSize * (0.25 + 0.5 * j / kPositions);
            const HeightSample found = surface.at(x, y);
            const HeightSample exact = scanWideHills().at(x, y);
            worst = std::max({worst, std::abs(found.dxx - exact.dxx),
                              std::abs(found.dxy - exact.dxy), std::abs(found.dyy - exact.dyy)});
        }
    }
    return worst;
}

// A spline's second derivative is off by the pitch squared: no rounding of a height stops that.
TEST(FinePixels, CurvatureConvergesWithThePitch) {
    double last = curvatureError(fitSurface(mapOf(32, 3.0_um)));
    for (const int pixels : {64, 128, 256, 512, 1024}) {
        const double error = curvatureError(fitSurface(mapOf(pixels, 3.0_um)));
        RecordProperty("curvature_error_" + std::to_string(pixels), std::to_string(error));
        EXPECT_LT(error, last / 3.5) << pixels << " pixels";
        last = error;
    }
}

TEST(FinePixels, OfALargeScanAreRoundedAsMuchAsIsSaid) {
    const BSplineSurface surface = fitSurface(test::singlePrecision(mapOf(512, 3.0_um)));
    const double pitch = surface.grid().pitchX;
    const double rounding = 16.0 * 4.0 * 0x1p-24 * 5.0_nm / (pitch * pitch);
    EXPECT_TRUE(surface.grid().controlRests.empty());
    EXPECT_LT(curvatureError(surface), rounding);
    EXPECT_GT(curvatureError(surface), 0.02 * rounding);
}

TEST(FinePixels, AloneNeedMoreThanSinglePrecision) {
    EXPECT_TRUE(fitSurface(mapOf(16, 0.0)).grid().controlRests.empty());
    const BSplineSurface fine = fitSurface(mapOf(256, 0.0));
    ASSERT_EQ(fine.grid().controlRests.size(), fine.grid().controlHeights.size());
    // A control height is what at() is made of.
    const double third = 1.0 / 3.0;
    const double middle = fine.control(40, 50);
    const double across = fine.control(40, 49) + fine.control(40, 51);
    const double up = fine.control(39, 50) + fine.control(41, 50);
    const double corners =
        fine.control(39, 49) + fine.control(39, 51) + fine.control(41, 49) + fine.control(41, 51);
    const double height = 4.0 * third * third * middle + third * third * (across + up) +
                          0.25 * third * third * corners;
    const double pitch = fine.grid().pitchX;
    EXPECT_NEAR(fine.at(50.5 * pitch, 40.5 * pitch).height, height, 1e-23);
}

TEST(FinePixels, KeepTheirDigitsThroughLeveling) {
    HeightMap tilted = mapOf(256, 3.0_um);
    for (int row = 0; row < tilted.rows; ++row) {
        for (int column = 0; column < tilted.columns; ++column) {
            tilted.heights[tilted.index(row, column)] += 0.2 * column * tilted.pitchX;
        }
    }
    const double level = curvatureError(fitSurface(mapOf(256, 0.0)));
    const double error =
        curvatureError(fitSurface(leveled(std::move(tilted), {LevelingStep::Plane})));
    EXPECT_NEAR(error, level, 10.0);
}

}  // namespace
}  // namespace asperity
