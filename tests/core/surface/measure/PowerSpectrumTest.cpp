#include "core/surface/measure/PowerSpectrum.h"

#include "core/Error.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace asperity {
namespace {

constexpr double kWaveTurn = 2.0 * std::numbers::pi;
constexpr double kPixel = 4e-9;  // pitch along x [m]

/// Heights by position [pixel]; pixels of 4 nm by 4 nm times `aspect`.
HeightMap spectrumMap(int columns, int rows, const std::function<double(int, int)>& height,
                      double aspect = 1.0) {
    HeightMap map = flatMap({.columns = columns,
                             .rows = rows,
                             .sizeX = kPixel * columns,
                             .sizeY = aspect * kPixel * rows});
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights[map.index(row, column)] = height(column, row);
        }
    }
    return map;
}

HeightMap whiteNoise(int columns, int rows, double sigma, double aspect = 1.0) {
    std::mt19937 generator(7);
    std::normal_distribution<double> heights(0.0, sigma);
    return spectrumMap(
        columns, rows, [&](int, int) { return heights(generator); }, aspect);
}

PowerSpectrum spectrumOfAll(const HeightMap& map) {
    const HeightRows rows = rowsOf(map);
    return powerSpectrumOf(rows, allPixels(rows));
}

double sqOf(const HeightMap& map) {
    const HeightRows rows = rowsOf(map);
    return roughnessOf(rows, allPixels(rows)).sq;
}

/// Square height that the rings between two frequencies have together [m^2].
double powerIn(const PowerSpectrum& spectrum, double low = 0.0,
               double high = std::numeric_limits<double>::infinity()) {
    double power = 0.0;
    for (const SpectrumRing& ring : spectrum.rings) {
        if (ring.frequency >= low && ring.frequency <= high) {
            power += ring.density * ring.waves * spectrum.waveArea;
        }
    }
    return power;
}

/// Slope of the least-squares line through log density over log frequency.
double slopeBetween(const PowerSpectrum& spectrum, double low, double high) {
    double n = 0.0;
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    for (const SpectrumRing& ring : spectrum.rings) {
        if (ring.frequency >= low && ring.frequency <= high) {
            const double x = std::log(ring.frequency);
            const double y = std::log(ring.density);
            n += 1.0;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(PowerSpectrum, HasTheSquareOfSqTogether) {
    const auto ramp = [](int x, int y) { return 1e-9 * (0.3 * x - 0.1 * y) + 5e-6; };
    for (const HeightMap& map :
         {whiteNoise(96, 130, 2e-9), spectrumMap(200, 64, ramp, 3.0), whiteNoise(17, 5, 1e-12),
          spectrumMap(300, 1, ramp), spectrumMap(1, 40, ramp)}) {
        const double square = std::pow(sqOf(map), 2);
        EXPECT_NEAR(powerIn(spectrumOfAll(map)), square, 1e-9 * square)
            << map.columns << " x " << map.rows;
    }
}

/// Both with the rectangle's own waves and with those that padding puts between them.
TEST(PowerSpectrum, OfASineIsAPeakAtItsFrequencyWithItsPower) {
    for (const int side : {256, 300}) {
        const double period = 12.5;  // [pixel]
        const HeightMap map = spectrumMap(side, side, [=](int x, int y) {
            return 3e-9 * std::sin(kWaveTurn * (0.6 * x + 0.8 * y) / period);
        });
        const PowerSpectrum spectrum = spectrumOfAll(map);
        const auto peak = std::ranges::max_element(spectrum.rings, {}, &SpectrumRing::density);
        const double frequency = 1.0 / (period * kPixel);
        const double ring = 1.0 / (side * kPixel);
        EXPECT_NEAR(peak->frequency, frequency, ring);
        const double power = 0.5 * 3e-9 * 3e-9;
        EXPECT_NEAR(powerIn(spectrum, frequency - 3.0 * ring, frequency + 3.0 * ring), power,
                    0.02 * power);
    }
}

TEST(PowerSpectrum, OfWhiteNoiseIsFlatAtVarianceTimesThePixelArea) {
    const PowerSpectrum spectrum = spectrumOfAll(whiteNoise(512, 400, 2e-9, 1.5));
    const double expected = 2e-9 * 2e-9 * kPixel * 1.5 * kPixel;
    const double nyquist = 0.5 / kPixel;
    for (double low = 0.05; low < 1.15; low += 0.05) {
        double sum = 0.0;
        double count = 0.0;
        for (const SpectrumRing& ring : spectrum.rings) {
            const double share = ring.frequency / nyquist;
            if (share >= low && share < low + 0.05) {
                sum += ring.density * ring.waves;
                count += ring.waves;
            }
        }
        ASSERT_GT(count, 0.0);
        EXPECT_NEAR(sum / count, expected, 0.1 * expected) << low;
    }
}

/// Waves of all lengths in all directions with amplitudes that fall as f^-(1 + H): C ~ f^-2(1 + H),
/// Persson et al., J. Phys.: Condens. Matter 17 (2005) R1.
TEST(PowerSpectrum, OfASelfAffineSurfaceFallsWithTwiceOnePlusItsHurstExponent) {
    constexpr int kSide = 256;
    constexpr double kHurst = 0.8;
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> phases(0.0, kWaveTurn);
    HeightMap map = spectrumMap(kSide, kSide, [](int, int) { return 0.0; });
    constexpr int kMost = 80;
    for (int m = 0; m <= kMost; ++m) {
        for (int n = -kMost; n <= kMost; ++n) {
            const double wave = std::hypot(m, n);
            if (wave < 1.0 || wave > kMost || (m + n) % 3 != 0) {
                continue;
            }
            const double amplitude = 1e-9 * std::pow(wave, -1.0 - kHurst);
            const double phase = phases(generator);
            for (int row = 0; row < kSide; ++row) {
                for (int column = 0; column < kSide; ++column) {
                    map.heights[map.index(row, column)] +=
                        amplitude * std::cos(kWaveTurn * (m * column + n * row) / kSide + phase);
                }
            }
        }
    }
    const double lowest = 1.0 / (kSide * kPixel);
    EXPECT_NEAR(slopeBetween(spectrumOfAll(map), 6.0 * lowest, 70.0 * lowest),
                -2.0 * (1.0 + kHurst), 0.1);
}

/// A step without window would spread over all frequencies, as f^-2 along an axis.
TEST(PowerSpectrum, EdgesOfARectangleAddNothing) {
    const HeightMap map =
        spectrumMap(256, 256, [](int x, int) { return 1e-9 * std::sin(kWaveTurn * x / 512.0); });
    const PowerSpectrum spectrum = spectrumOfAll(map);
    const double square = std::pow(sqOf(map), 2);
    EXPECT_LT(powerIn(spectrum, 10.0 / (256 * kPixel)), 1e-5 * square);
}

/// (1 + c) / 2 times c - 1 / 2, with c = cos: (cos + cos of twice) / 4, and no constant.
TEST(PowerSpectrum, LeavesOutTheMeanUnderTheWindow) {
    const PowerSpectrum spectrum = spectrumOfAll(spectrumMap(
        256, 1, [](int x, int) { return -1e-9 * std::cos(kWaveTurn * (x + 0.5) / 256.0); }));
    EXPECT_NEAR(spectrum.rings[0].density, spectrum.rings[1].density,
                1e-6 * spectrum.rings[0].density);
    EXPECT_LT(spectrum.rings[2].density, 1e-6 * spectrum.rings[0].density);
}

TEST(PowerSpectrum, CountsFrequenciesInMetersAlongBothAxes) {
    const auto along = [](int /*x*/, int y) { return 1e-9 * std::sin(kWaveTurn * y / 16.0); };
    const PowerSpectrum spectrum = spectrumOfAll(spectrumMap(128, 128, along, 2.0));
    const auto peak = std::ranges::max_element(spectrum.rings, {}, &SpectrumRing::density);
    EXPECT_NEAR(peak->frequency, 1.0 / (16.0 * 2.0 * kPixel), 0.6 / (256 * kPixel));
}

TEST(PowerSpectrum, LeavesOutPixelsWithoutData) {
    HeightMap map = whiteNoise(128, 128, 2e-9);
    for (std::size_t i = 0; i < map.heights.size(); i += 13) {
        map.heights[i] = std::numeric_limits<double>::quiet_NaN();
    }
    const double square = std::pow(sqOf(map), 2);
    EXPECT_NEAR(powerIn(spectrumOfAll(map)), square, 1e-9 * square);
    map.heights.assign(map.heights.size(), std::numeric_limits<double>::quiet_NaN());
    EXPECT_THROW((void)spectrumOfAll(map), Error);
}

TEST(PowerSpectrum, OfOneHeightIsNone) {
    EXPECT_TRUE(spectrumOfAll(spectrumMap(20, 30, [](int, int) { return 3e-7; })).rings.empty());
    EXPECT_TRUE(spectrumOfAll(spectrumMap(1, 1, [](int, int) { return 3e-7; })).rings.empty());
}

TEST(PowerSpectrum, OfARectangleIsThatOfItsPixels) {
    const HeightMap map = whiteNoise(64, 64, 2e-9);
    const HeightRows rows = rowsOf(map);
    const PixelRectangle part{.column = 8, .row = 16, .columns = 32, .rows = 24};
    const double square = std::pow(roughnessOf(rows, part).sq, 2);
    EXPECT_NEAR(powerIn(powerSpectrumOf(rows, part)), square, 1e-9 * square);
    EXPECT_THROW((void)powerSpectrumOf(rows, {.column = 40, .row = 0, .columns = 32, .rows = 24}),
                 Error);
}

TEST(PowerSpectrum, StopsWhenCanceled) {
    struct Stop : Progress {
        void report(double fraction) override { reached = fraction; }
        [[nodiscard]] bool isCanceled() const override { return reached > 0.5; }
        double reached = 0.0;
    } stop;
    const HeightMap map = whiteNoise(64, 64, 2e-9);
    const HeightRows rows = rowsOf(map);
    EXPECT_THROW((void)powerSpectrumOf(rows, allPixels(rows), &stop), Canceled);
}

}  // namespace
}  // namespace asperity
