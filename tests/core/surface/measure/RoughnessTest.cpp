#include "core/surface/measure/Roughness.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAmplitude = 30e-9;  // [m]
constexpr double kPeriod = 200e-9;    // [m]

/// z = A sin(2 pi x / L), the same in all rows.
struct Wave {
    static double height(double x, double /*y*/) {
        return kAmplitude * std::sin(2.0 * kPi * x / kPeriod);
    }
};

/// One period in `columns` pixels, with `extra` further ones.
HeightMap wave(int columns, int extra = 0) {
    const double pitch = kPeriod / columns;
    return sampledMap({.columns = columns + extra,
                       .rows = 3,
                       .sizeX = pitch * (columns + extra),
                       .sizeY = 3.0 * pitch},
                      Wave{});
}

Roughness measured(const HeightMap& map) {
    const HeightRows rows = rowsOf(map);
    return roughnessOf(rows, allPixels(rows));
}

/// What halving the pitch leaves of an error that falls with its square.
double extrapolated(double coarse, double fine) { return fine + (fine - coarse) / 3.0; }

TEST(Roughness, OfASineAgreesWithTheClosedForms) {
    // Peaks and valleys lie on pixels where the number of them is 4 n + 2.
    const Roughness coarse = measured(wave(2002));
    const Roughness fine = measured(wave(4004 + 2));
    EXPECT_NEAR(coarse.sq, kAmplitude / std::numbers::sqrt2, 1e-13 * kAmplitude);
    EXPECT_NEAR(coarse.sz, 2.0 * kAmplitude, 1e-13 * kAmplitude);
    EXPECT_NEAR(coarse.mean, 0.0, 1e-14 * kAmplitude);
    const double sa = 2.0 * kAmplitude / kPi;
    EXPECT_NEAR(fine.sa, sa, 1e-6 * sa);
    EXPECT_NEAR(extrapolated(measured(wave(2000)).sa, measured(wave(4000)).sa), sa, 1e-11 * sa);
}

TEST(Roughness, MomentsAndGradientOfASineAgreeWithTheClosedForms) {
    const Roughness fine = measured(wave(2002, 1));
    const Roughness period = measured(wave(2002));
    EXPECT_NEAR(period.ssk.value(), 0.0, 1e-12);
    EXPECT_NEAR(period.sku.value(), 1.5, 1e-12);
    EXPECT_NEAR(period.sp, kAmplitude, 1e-13 * kAmplitude);
    EXPECT_NEAR(period.sv, kAmplitude, 1e-13 * kAmplitude);
    const double sdq = kAmplitude * 2.0 * kPi / kPeriod / std::numbers::sqrt2;
    EXPECT_NEAR(fine.sdq, sdq, 1e-6 * sdq);
    EXPECT_NEAR(extrapolated(measured(wave(2000, 1)).sdq, measured(wave(4000, 1)).sdq), sdq,
                1e-11 * sdq);
}

/// A cone of height h on its disk, around which there is no data: mean h / 3, Sa 16 h / 81,
/// Sq h / sqrt 18, Ssk 2 sqrt 2 / 5, Sku 2.4.
TEST(Roughness, OfAConeAgreesWithTheClosedForms) {
    constexpr int kSide = 801;
    constexpr double kRadius = 400.0;  // [m], of 1 m pixels
    HeightMap map = flatMap({.columns = kSide, .rows = kSide, .sizeX = kSide, .sizeY = kSide});
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            const double share = std::hypot(row - kRadius, column - kRadius) / kRadius;
            map.heights[map.index(row, column)] = share <= 1.0
                                                      ? kAmplitude * (1.0 - share)
                                                      : std::numeric_limits<double>::quiet_NaN();
        }
    }
    const Roughness roughness = measured(map);
    const double sq = kAmplitude / std::sqrt(18.0);
    EXPECT_NEAR(roughness.mean, kAmplitude / 3.0, 1e-3 * kAmplitude);
    EXPECT_NEAR(roughness.sa, 16.0 / 81.0 * kAmplitude, 1e-3 * kAmplitude);
    EXPECT_NEAR(roughness.sq, sq, 1e-3 * sq);
    EXPECT_NEAR(roughness.sp, 2.0 / 3.0 * kAmplitude, 1e-3 * kAmplitude);
    EXPECT_NEAR(roughness.sv, 1.0 / 3.0 * kAmplitude, 1e-3 * kAmplitude);
    EXPECT_NEAR(roughness.ssk.value(), 0.4 * std::numbers::sqrt2, 2e-3);
    EXPECT_NEAR(roughness.sku.value(), 2.4, 5e-3);
    EXPECT_NEAR(roughness.sdq, kAmplitude / kRadius, 1e-4 * kAmplitude / kRadius);
}

TEST(Roughness, OfAStepWithEqualHalvesHasNoSkewnessAndKurtosisOne) {
    HeightMap map = flatMap({.columns = 10, .rows = 4, .sizeX = 10.0, .sizeY = 4.0});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 5; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = kAmplitude;
        }
    }
    const Roughness roughness = measured(map);
    EXPECT_NEAR(roughness.sq, 0.5 * kAmplitude, 1e-14 * kAmplitude);
    EXPECT_NEAR(roughness.ssk.value(), 0.0, 1e-12);
    EXPECT_NEAR(roughness.sku.value(), 1.0, 1e-12);
    // One of the nine columns of squares has the gradient, a pixel wide.
    EXPECT_NEAR(roughness.sdq, kAmplitude / 3.0, 1e-14 * kAmplitude);
}

TEST(Roughness, OfOneHeightHasNeitherSkewnessNorKurtosis) {
    const Roughness flat = measured(flatMap({.columns = 4, .rows = 3, .sizeX = 4.0, .sizeY = 3.0}));
    EXPECT_FALSE(flat.ssk);
    EXPECT_FALSE(flat.sku);
    EXPECT_EQ(flat.sdq, 0.0);
    const Roughness pixel =
        measured(flatMap({.columns = 1, .rows = 1, .sizeX = 1.0, .sizeY = 1.0}));
    EXPECT_FALSE(pixel.ssk);
    EXPECT_EQ(pixel.sp, 0.0);
    EXPECT_EQ(pixel.squares, 0U);
    EXPECT_EQ(pixel.sdq, 0.0);
}

/// The length of a sine over its base is 2 / pi sqrt(1 + k^2) E(k^2 / (1 + k^2)), k = 2 pi A / L.
TEST(Roughness, SdrOfASineAgreesWithTheEllipticIntegral) {
    const double k = 2.0 * kPi * kAmplitude / kPeriod;
    const double exact =
        2.0 / kPi * std::sqrt(1.0 + k * k) * std::comp_ellint_2(k / std::sqrt(1.0 + k * k)) - 1.0;
    const Roughness coarse = measured(wave(2000, 1));  // the squares are one fewer
    const Roughness fine = measured(wave(4000, 1));
    EXPECT_EQ(coarse.squares, 2U * 2000U);
    EXPECT_NEAR(fine.sdr, exact, 1e-6 * exact);
    EXPECT_NEAR(extrapolated(coarse.sdr, fine.sdr), exact, 1e-11 * exact);
}

TEST(Roughness, SdrOfATiltedPlaneIsThatOfItsNormal) {
    HeightMap map = flatMap({.columns = 13, .rows = 9, .sizeX = 130.0_nm, .sizeY = 180.0_nm});
    EXPECT_EQ(measured(map).sdr, 0.0);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] =
                0.3 * column * map.pitchX - 1.7 * row * map.pitchY;
        }
    }
    const double exact = std::sqrt(1.0 + 0.3 * 0.3 + 1.7 * 1.7) - 1.0;
    EXPECT_NEAR(measured(map).sdr, exact, 1e-14);
    EXPECT_NEAR(measured(map).sdq, std::hypot(0.3, 1.7), 1e-13);
    // Slopes so small that 1 + slope^2 is 1.
    for (double& height : map.heights) {
        height *= 1e-10;
    }
    EXPECT_NEAR(measured(map).sdr, 0.5e-20 * (0.3 * 0.3 + 1.7 * 1.7), 1e-32);
}

/// One corner of a square lifted by its side: of the two ways to split it one has a triangle with
/// two slopes and a flat one, the other two triangles with one slope each.
TEST(Roughness, SdrIsTheMeanOfBothWaysToSplitASquare) {
    HeightMap map = flatMap({.columns = 2, .rows = 2, .sizeX = 2.0, .sizeY = 2.0});
    map.heights[1] = 1.0;
    const double oneWay = 0.5 * std::sqrt(3.0) + 0.5;
    const double otherWay = std::sqrt(2.0);
    EXPECT_NEAR(measured(map).sdr, 0.5 * (oneWay + otherWay) - 1.0, 1e-15);
}

TEST(Roughness, OfAnOffsetLosesNoDigits) {
    HeightMap map = wave(2002);
    const Roughness low = measured(map);
    for (double& height : map.heights) {
        height += 1e-6;
    }
    EXPECT_NEAR(measured(map).sq, low.sq, 1e-13 * low.sq);
    EXPECT_NEAR(measured(map).mean, 1e-6, 1e-20);
}

TEST(Roughness, LeavesOutPixelsWithoutData) {
    HeightMap map = flatMap({.columns = 4, .rows = 4, .sizeX = 4.0, .sizeY = 4.0});
    map.heights[map.index(1, 1)] = std::numeric_limits<double>::quiet_NaN();
    map.invalid.assign(16, false);
    map.invalid[map.index(3, 3)] = true;
    map.heights[map.index(3, 3)] = 100.0;
    map.heights[map.index(0, 0)] = 14.0;
    const Roughness roughness = measured(map);
    EXPECT_EQ(roughness.pixels, 14U);
    EXPECT_EQ(roughness.squares, 9U - 4U - 1U);
    EXPECT_EQ(roughness.mean, 1.0);
    EXPECT_NEAR(roughness.sa, (13.0 + 13.0) / 14.0, 1e-15);
    EXPECT_NEAR(roughness.sq, std::sqrt((13.0 * 13.0 + 13.0) / 14.0), 1e-15);
    EXPECT_EQ(roughness.sz, 14.0);
    EXPECT_EQ(roughness.sdr, 0.0);  // the high pixel has no whole square
}

TEST(Roughness, OfARectangleIsThatOfItsPixelsAlone) {
    HeightMap map = flatMap({.columns = 10, .rows = 6, .sizeX = 100.0_nm, .sizeY = 120.0_nm});
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] = 1e-9 * static_cast<double>(i % 7 * i % 11);
    }
    const HeightRows rows = rowsOf(map);
    // Centers at 5, 15, ... nm along x and 10, 30, ... nm along y; any two opposite corners.
    const PixelRectangle pixels =
        pixelsBetween(rows, Vector2(36.0_nm, 29.0_nm), Vector2(14.0_nm, 71.0_nm));
    EXPECT_EQ(pixels, (PixelRectangle{.column = 1, .row = 2, .columns = 3, .rows = 3}));
    HeightMap part = flatMap({.columns = 3, .rows = 3, .sizeX = 30.0_nm, .sizeY = 60.0_nm});
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            part.heights[part.index(row, column)] = map.at(row + 2, column + 1);
        }
    }
    const Roughness ofPart = measured(part);
    const Roughness ofPixels = roughnessOf(rows, pixels);
    EXPECT_EQ(ofPixels.sa, ofPart.sa);
    EXPECT_EQ(ofPixels.sq, ofPart.sq);
    EXPECT_EQ(ofPixels.sz, ofPart.sz);
    EXPECT_NEAR(ofPixels.sdr, ofPart.sdr, 1e-14);  // of another pitch, by rounding
    EXPECT_EQ(pixelsBetween(rows, Vector2(-1.0, -1.0), Vector2(1.0, 1.0)), allPixels(rows));
}

TEST(Roughness, RefusesRectanglesWithoutPixels) {
    const HeightMap map = flatMap({.columns = 4, .rows = 4, .sizeX = 4.0, .sizeY = 4.0});
    const HeightRows rows = rowsOf(map);
    EXPECT_THROW((void)pixelsBetween(rows, Vector2(0.6, 0.6), Vector2(1.4, 1.4)), Error);
    EXPECT_THROW((void)pixelsBetween(rows, Vector2(5.0, 0.0), Vector2(9.0, 4.0)), Error);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)pixelsBetween(rows, Vector2(nan, 0.0), Vector2(9.0, 4.0)), Error);
    EXPECT_THROW((void)roughnessOf(rows, {.column = 2, .row = 0, .columns = 3, .rows = 1}), Error);
    HeightMap holey = map;
    holey.invalid.assign(16, true);
    EXPECT_THROW((void)measured(holey), Error);
}

TEST(Roughness, OfAMapInSinglePrecisionAndOfASurfaceIsThatOfItsHeights) {
    const HeightMap map = wave(202);
    const Roughness exact = measured(map);
    const ScanMap scan = test::singlePrecision(map);
    const HeightRows rows = rowsOf(scan);
    EXPECT_NEAR(roughnessOf(rows, allPixels(rows)).sq, exact.sq, 1e-7 * exact.sq);
    HeightMap holey = map;
    holey.invalid.assign(holey.heights.size(), false);
    holey.invalid[7] = true;
    const BSplineSurface surface = fitSurface(holey);
    const HeightRows ofSurface = rowsOf(surface);
    const Roughness roughness = roughnessOf(ofSurface, allPixels(ofSurface));
    EXPECT_EQ(roughness.pixels, holey.heights.size() - 1);
    EXPECT_NEAR(roughness.sq, measured(holey).sq, 1e-6 * exact.sq);
    EXPECT_NEAR(roughness.sdr, measured(holey).sdr, 1e-5 * exact.sdr);
}

TEST(Roughness, HistogramCountsEachHeightOnceInItsBin) {
    HeightMap map = flatMap({.columns = 8, .rows = 16, .sizeX = 8.0, .sizeY = 16.0});
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.heights[i] = 1e-6 + 1e-9 * static_cast<double>(i);  // 128 heights, evenly apart
    }
    map.heights[5] = std::numeric_limits<double>::quiet_NaN();
    const HeightRows rows = rowsOf(map);
    const HeightHistogram histogram = histogramOf(rows, allPixels(rows), measured(map));
    ASSERT_EQ(histogram.counts.size(), 128U);
    EXPECT_NEAR(histogram.width, 127e-9 / 128.0, 1e-18);
    EXPECT_NEAR(histogram.middle(127), 1e-6 + 127e-9 * 127.5 / 128.0, 1e-18);
    for (std::size_t bin = 0; bin < 128; ++bin) {
        EXPECT_EQ(histogram.counts[bin], bin == 5 ? 0U : 1U) << bin;
    }
}

TEST(Roughness, HistogramOfOneHeightIsOneBin) {
    const HeightMap map = flatMap({.columns = 4, .rows = 3, .sizeX = 4.0, .sizeY = 3.0});
    const HeightRows rows = rowsOf(map);
    const HeightHistogram histogram = histogramOf(rows, allPixels(rows), measured(map));
    EXPECT_EQ(histogram.counts, std::vector<std::size_t>{12});
    EXPECT_EQ(histogram.width, 0.0);
}

}  // namespace
}  // namespace asperity
