#include "core/surface/BSplineSurface.h"

#include "core/Error.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/FloatingPointTraps.h"
#include "tests/support/StorageError.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

ASPERITY_TRAP_FLOATING_POINT();

using test::kInfinity;
using test::kNan;
using test::StorageError;
using test::storageErrorOf;

HeightMap randomMap(int columns, int rows) {
    HeightMap map = flatMap(
        {.columns = columns, .rows = rows, .sizeX = columns * 2.0_nm, .sizeY = rows * 3.0_nm});
    Random random(17);
    for (double& height : map.heights) {
        height = random.uniform(-5.0_nm, 5.0_nm);
    }
    return map;
}

TEST(BSplineFit, PassesThroughEveryPixelCenter) {
    for (const auto& [columns, rows] :
         {std::pair{1, 1}, {1, 7}, {7, 1}, {2, 2}, {2, 9}, {3, 3}, {4, 3}, {40, 31}}) {
        const HeightMap map = randomMap(columns, rows);
        const BSplineSurface surface = fitSurface(map);
        const double tolerance = 1e-13 * 5.0_nm + storageErrorOf(surface).height;
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const double x = (column + 0.5) * map.pitchX;
                const double y = (rows - row - 0.5) * map.pitchY;
                ASSERT_NEAR(surface.at(x, y).height, map.at(row, column), tolerance)
                    << columns << " x " << rows;
            }
        }
    }
}

struct Quadratic {
    [[nodiscard]] HeightSample at(double x, double y) const {
        return {.height = 1e-9 + 0.1 * x - 0.2 * y + 1e6 * (x * x - 0.5 * x * y + 2.0 * y * y),
                .dx = 0.1 + 1e6 * (2.0 * x - 0.5 * y),
                .dy = -0.2 + 1e6 * (4.0 * y - 0.5 * x),
                .dxx = 2e6,
                .dxy = -0.5e6,
                .dyy = 4e6};
    }
    [[nodiscard]] double height(double x, double y) const { return at(x, y).height; }
};

TEST(BSplineFit, GivesBackQuadraticsUpToTheScansEdge) {
    const ScanSize size{.columns = 12, .rows = 8, .sizeX = 120.0_nm, .sizeY = 160.0_nm};
    const BSplineSurface surface = fitSurface(sampledMap(size, Quadratic{}));
    const StorageError storage = storageErrorOf(surface);
    for (int i = 0; i <= 24; ++i) {
        const double x = size.sizeX * i / 24.0;
        const double y = size.sizeY * (24 - i) / 24.0;
        const HeightSample found = surface.at(x, y);
        const HeightSample exact = Quadratic{}.at(x, y);
        EXPECT_NEAR(found.height, exact.height, 1e-21 + storage.height);
        EXPECT_NEAR(found.dx, exact.dx, 1e-12 + storage.slope);
        EXPECT_NEAR(found.dy, exact.dy, 1e-12 + storage.slope);
        EXPECT_NEAR(found.dxx, exact.dxx, 1e-4 + storage.curvature);
        EXPECT_NEAR(found.dxy, exact.dxy, 1e-4 + storage.curvature);
        EXPECT_NEAR(found.dyy, exact.dyy, 1e-4 + storage.curvature);
    }
}

/// Largest error inside the scan of height [amplitude], slopes and second derivatives
/// [amplitude per period], away from the borders.
std::array<double, 3> eggBoxErrors(int pixels) {
    const EggBox shape{.amplitude = 1.0, .periodX = 1.0, .periodY = 0.8, .phaseX = 0.3};
    const ScanSize size{.columns = pixels, .rows = pixels, .sizeX = 4.0, .sizeY = 4.0};
    const BSplineSurface surface = fitSurface(sampledMap(size, shape));
    std::array<double, 3> errors{};
    for (int i = 0; i < 2000; ++i) {
        const double x = 1.0 + 2.0 * std::fmod(i * 0.6180339887, 1.0);
        const double y = 1.0 + 2.0 * std::fmod(i * 0.7548776662, 1.0);
        const HeightSample found = surface.at(x, y);
        const HeightSample exact = shape.at(x, y);
        errors[0] = std::max(errors[0], std::abs(found.height - exact.height));
        errors[1] =
            std::max({errors[1], std::abs(found.dx - exact.dx), std::abs(found.dy - exact.dy)});
        errors[2] = std::max({errors[2], std::abs(found.dxx - exact.dxx),
                              std::abs(found.dxy - exact.dxy), std::abs(found.dyy - exact.dyy)});
    }
    return errors;
}

TEST(BSplineFit, ErrorsFallAtTheOrderOfACubicSpline) {
    const std::array<double, 3> coarse = eggBoxErrors(64);
    const std::array<double, 3> fine = eggBoxErrors(128);
    EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 4.0, 0.2);
    EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 3.0, 0.2);
    EXPECT_NEAR(std::log2(coarse[2] / fine[2]), 2.0, 0.2);
    EXPECT_LT(fine[0], 3e-5);
}

TEST(BSplineSurface, TurnsTheTopRowUp) {
    HeightMap map = flatMap({.columns = 5, .rows = 4, .sizeX = 5.0_nm, .sizeY = 4.0_nm});
    map.heights[map.index(0, 4)] = 1.0_nm;  // the image's upper right corner
    const BSplineSurface surface = fitSurface(map);
    const double tolerance = 1e-21 + storageErrorOf(surface).height;
    EXPECT_NEAR(surface.at(4.5_nm, 3.5_nm).height, 1.0_nm, tolerance);
    EXPECT_NEAR(surface.at(4.5_nm, 0.5_nm).height, 0.0, tolerance);
}

TEST(BSplineSurface, DerivativesAreThoseOfTheHeight) {
    const BSplineSurface surface = fitSurface(randomMap(9, 8));
    const double step = 1e-5 * 1.0_nm;
    for (const auto& [x, y] :
         {std::pair{7.3_nm, 11.1_nm}, {0.4_nm, 12.0_nm}, {17.6_nm, 23.5_nm}, {9.1_nm, 0.7_nm}}) {
        const HeightSample here = surface.at(x, y);
        const HeightSample right = surface.at(x + step, y);
        const HeightSample left = surface.at(x - step, y);
        const HeightSample above = surface.at(x, y + step);
        const HeightSample below = surface.at(x, y - step);
        EXPECT_NEAR(here.dx, (right.height - left.height) / (2 * step), 1e-8);
        EXPECT_NEAR(here.dy, (above.height - below.height) / (2 * step), 1e-8);
        EXPECT_NEAR(here.dxx, (right.dx - left.dx) / (2 * step), 20.0);
        EXPECT_NEAR(here.dxy, (above.dx - below.dx) / (2 * step), 20.0);
        EXPECT_NEAR(here.dyy, (above.dy - below.dy) / (2 * step), 20.0);
    }
}

TEST(BSplineSurface, IsSmoothAcrossSpansAndPastTheOutermostPixelCenters) {
    const BSplineSurface surface = fitSurface(randomMap(9, 8));
    for (const double x : {1.0_nm, 3.0_nm, 9.0_nm, 17.0_nm}) {
        const HeightSample left = surface.at(x * (1.0 - 1e-12), 5.2_nm);
        const HeightSample right = surface.at(x * (1.0 + 1e-12), 5.2_nm);
        EXPECT_NEAR(left.height, right.height, 1e-19);
        EXPECT_NEAR(left.dx, right.dx, 1e-9);
        EXPECT_NEAR(left.dxx * 1.0_nm, right.dxx * 1.0_nm, 1e-9);
    }
}

TEST(BSplineSurface, ClampsPositionsOutsideTheScanToItsEdge) {
    const BSplineSurface surface = fitSurface(randomMap(9, 8));
    EXPECT_EQ(surface.at(-1.0_um, 5.0_nm).height, surface.at(0.0, 5.0_nm).height);
    EXPECT_EQ(surface.at(1.0e300, 5.0_nm).height, surface.at(surface.sizeX(), 5.0_nm).height);
    EXPECT_EQ(surface.at(kInfinity, -kInfinity).height, surface.at(surface.sizeX(), 0.0).height);
    EXPECT_EQ(surface.at(kNan, kNan).height, surface.at(0.0, 0.0).height);
}

TEST(BSplineSurface, KnowsItsExtent) {
    const BSplineSurface surface = fitSurface(randomMap(9, 8));
    EXPECT_TRUE(surface.contains(0.0, surface.sizeY()));
    EXPECT_FALSE(surface.contains(-1e-15, 1.0_nm));
    EXPECT_FALSE(surface.contains(1.0_nm, 24.1_nm));
    EXPECT_FALSE(surface.contains(kNan, 1.0_nm));
}

TEST(BSplineSurface, RemembersWhichPixelsWereFilled) {
    HeightMap map = randomMap(9, 8);
    for (int column = 0; column < 9; ++column) {
        map.heights[map.index(1, column)] = kNan;
    }
    const BSplineSurface surface = fitSurface(map);
    EXPECT_FALSE(surface.isMeasured(4.0_nm, 19.5_nm));  // second row from the top
    EXPECT_TRUE(surface.isMeasured(4.0_nm, 23.0_nm));
    EXPECT_TRUE(surface.isMeasured(4.0_nm, 17.0_nm));
    EXPECT_TRUE(surface.isMeasured(1.0, 1.0));
    EXPECT_TRUE(std::isfinite(surface.at(4.0_nm, 19.5_nm).height));
    EXPECT_TRUE(fitSurface(randomMap(2, 2)).isMeasured(1.0_nm, 1.0_nm));
}

TEST(BSplineSurface, IsLevelAlongAnAxisWithOnePixel) {
    const HeightMap map = randomMap(1, 6);
    const BSplineSurface surface = fitSurface(map);
    const HeightSample middle = surface.at(1.0_nm, 7.0_nm);
    const HeightSample edge = surface.at(0.1_nm, 7.0_nm);
    EXPECT_NEAR(middle.height, edge.height, 1e-22);
    EXPECT_NEAR(edge.dx, 0.0, 1e-12);
    EXPECT_NE(edge.dy, 0.0);
}

TEST(BSplineSurface, KeepsItsRelativeAccuracyFromPicometersToMillimeters) {
    for (const double amplitude : {1.0_pm, 1e-3}) {
        const ScanSize size{.columns = 64, .rows = 64, .sizeX = 1.0_um, .sizeY = 1.0_um};
        const EggBox shape{.amplitude = amplitude, .periodX = 0.5_um, .periodY = 0.5_um};
        const HeightMap map = sampledMap(size, shape);
        const BSplineSurface surface = fitSurface(map);
        const double x = 20.5 * map.pitchX;
        const double y = (64 - 10 - 0.5) * map.pitchY;
        const double tolerance = 1e-14 * amplitude + storageErrorOf(surface).height;
        EXPECT_LT(tolerance, 2e-6 * amplitude);
        EXPECT_NEAR(surface.at(x, y).height, map.at(10, 20), tolerance);
    }
}

TEST(BSplineSurface, HeightsFarFromZeroKeepTheDigitsOfTheirRange) {
    HeightMap map = randomMap(9, 8);
    const BSplineSurface low = fitSurface(map);
    for (double& height : map.heights) {
        height += 1.0_um;
    }
    const BSplineSurface high = fitSurface(map);
    EXPECT_NEAR(high.grid().datum, 1.0_um, 20.0_nm);
    EXPECT_NEAR(high.at(7.3_nm, 11.1_nm).height, 1.0_um + low.at(7.3_nm, 11.1_nm).height,
                2.0 * storageErrorOf(low).height);
    EXPECT_GE(high.heightScale(), 1.0_um);
    constexpr std::size_t kControl = 3 * 11 + 4;
    EXPECT_EQ(high.control(2, 3),
              high.grid().datum + (static_cast<double>(high.grid().controlHeights[kControl]) +
                                   static_cast<double>(high.grid().controlRests[kControl])));
}

TEST(BSplineFit, RefusesHeightsThatSinglePrecisionCannotHold) {
    HeightMap map = randomMap(3, 3);
    map.heights[0] = 1e39;
    EXPECT_THROW((void)fitSurface(map), Error);
}

TEST(BSplineSurface, NoValleyIsCurvedMoreStronglyThanItsBound) {
    for (const auto& [columns, rows] : {std::pair{9, 8}, {2, 2}, {1, 6}, {40, 3}, {600, 500}}) {
        const BSplineSurface surface = fitSurface(randomMap(columns, rows));
        double strongest = 0.0;
        for (int i = 0; i < 3000; ++i) {
            const HeightSample s =
                surface.at(surface.sizeX() * std::fmod(i * 0.6180339887, 1.0),
                           surface.sizeY() * (i % 4 == 0 ? 0.999 : std::fmod(i * 0.754877, 1.0)));
            const double half = 0.5 * (s.dxx - s.dyy);
            strongest = std::max(strongest, 0.5 * (s.dxx + s.dyy) + std::hypot(half, s.dxy));
        }
        EXPECT_LE(strongest, surface.bounds().all().concavity) << columns << " x " << rows;
        EXPECT_GE(strongest, 0.1 * surface.bounds().all().concavity) << columns << " x " << rows;
    }
}

TEST(BSplineSurface, ContinuesItsControlPointsExactly) {
    const BSplineSurface surface = fitSurface(randomMap(6, 5));
    // With a fourth difference of zero the outer span's polynomial goes on.
    for (const int row : {-4, -1, 2, 9}) {
        const auto c = [&](int column) { return surface.control(row, column); };
        EXPECT_NEAR(c(-4) - 4 * c(-3) + 6 * c(-2) - 4 * c(-1) + c(0), 0.0,
                    1e-12 * std::abs(c(-4)) + 1e-20);
        EXPECT_NEAR(c(4) - 4 * c(5) + 6 * c(6) - 4 * c(7) + c(8), 0.0,
                    1e-12 * std::abs(c(8)) + 1e-20);
    }
}

TEST(BSplineSurface, RefusesGridsThatDoNotMatch) {
    BSplineSurface::Grid grid{.columns = 2,
                              .rows = 2,
                              .pitchX = 1.0_nm,
                              .pitchY = 1.0_nm,
                              .controlHeights = PixelVector<float>(16, 0.0F),
                              .invalid = {}};
    EXPECT_NO_THROW(BSplineSurface{grid});
    auto broken = grid;
    broken.controlHeights.resize(15);
    EXPECT_THROW(BSplineSurface{broken}, Error);
    broken = grid;
    broken.pitchX = 0.0;
    EXPECT_THROW(BSplineSurface{broken}, Error);
    broken = grid;
    broken.datum = kNan;
    EXPECT_THROW(BSplineSurface{broken}, Error);
    broken = grid;
    broken.controlHeights[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(BSplineSurface{broken}, Error);
    broken = grid;
    broken.invalid.resize(3);
    EXPECT_THROW(BSplineSurface{broken}, Error);
}

}  // namespace
}  // namespace asperity
