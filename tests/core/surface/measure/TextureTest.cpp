#include "core/surface/measure/Texture.h"

#include "core/Error.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kMost = 0.02;  // relative error

/// Heights by position [pixel], on pixels of 1 m by 1 m.
HeightMap pixelMap(int columns, int rows, const std::function<double(double, double)>& height) {
    HeightMap map = flatMap({.columns = columns,
                             .rows = rows,
                             .sizeX = static_cast<double>(columns),
                             .sizeY = static_cast<double>(rows)});
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights[map.index(row, column)] = height(column, row);
        }
    }
    return map;
}

Texture textureOfAll(const HeightMap& map) {
    const HeightRows rows = rowsOf(map);
    return textureOf(rows, allPixels(rows));
}

/// Waves along x and y, whose autocorrelation is the mean of two cosines. It is 0.2 on an axis
/// where the cosine is -0.6, on the diagonal of equal phases where both are 0.2.
HeightMap crossedWaves(double periodX, double periodY) {
    return pixelMap(600, 600, [=](double x, double y) {
        return 1e-9 * (std::sin(kTurn * x / periodX) + std::sin(kTurn * y / periodY));
    });
}

TEST(Texture, OfCrossedWavesAgreesWithTheClosedForm) {
    const Texture equal = textureOfAll(crossedWaves(30.0, 30.0));
    const double diagonal = std::numbers::sqrt2 * std::acos(0.2);
    EXPECT_EQ(equal.step, 1);
    EXPECT_NEAR(equal.sal.value(), diagonal * 30.0 / kTurn, kMost * 30.0 * diagonal / kTurn);
    EXPECT_NEAR(equal.str.value(), diagonal / std::acos(-0.6), kMost);
    const Texture longer = textureOfAll(crossedWaves(20.0, 60.0));
    const double axis = std::acos(-0.6) * 20.0 / kTurn;
    EXPECT_NEAR(longer.sal.value(), axis, kMost * axis);
    EXPECT_NEAR(longer.str.value(), 1.0 / 3.0, kMost / 3.0);
}

/// 24 waves of one length in many directions, all whole numbers of times on the scan: m^2 + n^2 =
/// 5525. The autocorrelation is J0(2 pi r / wavelength) nearby; it is 0.2 at r = 0.3249 of one.
TEST(Texture, OfWavesInAllDirectionsIsThatOfTheBesselFunction) {
    constexpr int kSide = 1024;
    constexpr int kSquare = 5525;
    const HeightMap map = pixelMap(kSide, kSide, [](double x, double y) {
        double height = 0.0;
        for (int m = 0; m * m <= kSquare; ++m) {
            const int n = static_cast<int>(std::lround(std::sqrt(kSquare - m * m)));
            if (m * m + n * n == kSquare) {
                height += std::sin(kTurn * (m * x + n * y) / kSide + 0.7 * m * m) +
                          std::sin(kTurn * (m * x - n * y) / kSide + 0.3 * n * m);
            }
        }
        return 1e-9 * height;
    });
    double low = 1.0;
    double high = 2.4;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        (std::cyl_bessel_j(0.0, middle) > 0.2 ? low : high) = middle;
    }
    const double exact = low * kSide / std::sqrt(kSquare) / kTurn;
    const Texture texture = textureOfAll(map);
    EXPECT_NEAR(texture.sal.value(), exact, kMost * exact);
    EXPECT_NEAR(texture.str.value(), 1.0, kMost);
}

/// The crests go on to the border: the slowest decay is not reached, the fastest is acos(0.2) / k.
TEST(Texture, OfAPlaneWaveHasALengthWithoutAspectRatio) {
    const HeightMap map = pixelMap(
        500, 300, [](double x, double /*y*/) { return 1e-9 * std::sin(kTurn * x / 50.0); });
    const Texture texture = textureOfAll(map);
    const double exact = std::acos(0.2) * 50.0 / kTurn;
    EXPECT_NEAR(texture.sal.value(), exact, kMost * exact);
    EXPECT_FALSE(texture.str);
}

TEST(Texture, IsNotThatOfARepeatedScan) {
    // Half of a period: repeated, it would be a wave of half the length.
    const HeightMap map =
        pixelMap(400, 400, [](double x, double /*y*/) { return std::cos(kTurn * x / 800.0); });
    const Texture texture = textureOfAll(map);
    // At a lag the mean of cos a cos(a + lag) over the pairs of pixels is cos(lag) / 2 minus
    // sin(lag) / (2 (pi - lag)) in phases; at no lag it is 1 / 2.
    double low = 0.5;
    double high = 1.5;
    while (high - low > 1e-12) {
        const double lag = 0.5 * (low + high);
        const double value = std::cos(lag) - std::sin(lag) / (std::numbers::pi - lag);
        (value > 0.2 ? low : high) = lag;
    }
    EXPECT_NEAR(texture.sal.value(), low * 800.0 / kTurn, kMost * low * 800.0 / kTurn);
}

TEST(Texture, PitchesAndStepCountInMeters) {
    HeightMap map = crossedWaves(30.0, 30.0);
    map.pitchX = 2e-9;
    map.pitchY = 6e-9;
    const Texture texture = textureOfAll(map);
    const double axis = std::acos(-0.6) * 60e-9 / kTurn;
    EXPECT_NEAR(texture.sal.value(), axis, kMost * axis);
    EXPECT_NEAR(texture.str.value(), 1.0 / 3.0, kMost / 3.0);
    const HeightMap large = pixelMap(4100, 900, [](double x, double y) {
        return std::sin(kTurn * x / 120.0) + std::sin(kTurn * y / 60.0);
    });
    const Texture coarse = textureOfAll(large);
    EXPECT_EQ(coarse.step, 3);
    const double across = std::acos(-0.6) * 60.0 / kTurn;
    EXPECT_NEAR(coarse.sal.value(), across, kMost * across);
    EXPECT_NEAR(coarse.str.value(), 0.5, 0.5 * kMost);
}

TEST(Texture, LeavesOutPixelsWithoutData) {
    HeightMap map = crossedWaves(30.0, 30.0);
    const Texture whole = textureOfAll(map);
    for (std::size_t i = 0; i < map.heights.size(); i += 1 + i % 7) {
        map.heights[i] = std::numeric_limits<double>::quiet_NaN();
    }
    const Texture holey = textureOfAll(map);
    EXPECT_NEAR(holey.sal.value(), whole.sal.value(), kMost * whole.sal.value());
    EXPECT_NEAR(holey.str.value(), whole.str.value(), kMost);
}

TEST(Texture, OfARectangleAndAnOffsetIsThatOfItsPixels) {
    HeightMap map = crossedWaves(30.0, 30.0);
    const HeightRows rows = rowsOf(map);
    const PixelRectangle pixels{.column = 60, .row = 30, .columns = 240, .rows = 300};
    const Texture low = textureOf(rows, pixels);
    for (double& height : map.heights) {
        height += 1e-6;
    }
    EXPECT_NEAR(textureOf(rows, pixels).sal.value(), low.sal.value(), 1e-6 * low.sal.value());
    const double diagonal = std::numbers::sqrt2 * std::acos(0.2) * 30.0 / kTurn;
    EXPECT_NEAR(low.sal.value(), diagonal, kMost * diagonal);
}

TEST(Texture, IsEmptyWhereThereIsNoDecay) {
    const auto isEmpty = [](const HeightMap& map) {
        const Texture texture = textureOfAll(map);
        return !texture.sal && !texture.str;
    };
    const auto flat = [](double /*x*/, double /*y*/) { return 3e-9; };
    EXPECT_TRUE(isEmpty(pixelMap(1, 1, flat)));
    EXPECT_TRUE(isEmpty(pixelMap(40, 30, flat)));
    // The slow decay along y is not reached before the fast one along x could be known.
    EXPECT_TRUE(isEmpty(pixelMap(64, 1, [](double x, double /*y*/) { return std::sin(x); })));
}

TEST(Texture, RefusesRectanglesWithoutData) {
    HeightMap map = flatMap({.columns = 4, .rows = 4, .sizeX = 4.0, .sizeY = 4.0});
    const HeightRows rows = rowsOf(map);
    EXPECT_THROW((void)textureOf(rows, {.column = 2, .row = 0, .columns = 3, .rows = 1}), Error);
    map.heights.assign(16, std::numeric_limits<double>::quiet_NaN());
    EXPECT_THROW((void)textureOf(rows, allPixels(rows)), Error);
}

TEST(Texture, StopsWhenCanceled) {
    struct Stop : Progress {
        void report(double fraction) override { reached = fraction; }
        [[nodiscard]] bool isCanceled() const override { return reached > 0.5; }
        double reached = 0.0;
    } stop;
    const HeightMap map = crossedWaves(30.0, 30.0);
    const HeightRows rows = rowsOf(map);
    EXPECT_THROW((void)textureOf(rows, allPixels(rows), &stop), Canceled);
}

}  // namespace
}  // namespace asperity
