#include "core/uncertainty/FitResponse.h"

#include "core/surface/fit/BSplineFit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr int kColumns = 21;
constexpr int kRows = 17;

HeightMap mapOf(double scale, const auto& height) {
    HeightMap map{
        .columns = kColumns, .rows = kRows, .pitchX = 2e-9 * scale, .pitchY = 3e-9 * scale};
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            map.heights.push_back(height(row, column));
        }
    }
    return map;
}

/// The covariance by fitting one pixel after the other.
ReliefCovariance byImpulses(const Smoothing& smoothing, double x, double y) {
    ReliefCovariance sum = ReliefCovariance::Zero();
    for (int i = 0; i < kRows; ++i) {
        for (int j = 0; j < kColumns; ++j) {
            const HeightMap impulse = mapOf(
                1.0, [&](int row, int column) { return row == i && column == j ? 1e-9 : 0.0; });
            const Relief relief = reliefOf(fitSurface(impulse, smoothing).at(x, y)) * 1e9;
            sum += relief * relief.transpose();
        }
    }
    return sum;
}

void expectNear(const ReliefCovariance& found, const ReliefCovariance& expected) {
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const double scale = std::sqrt(expected(i, i) * expected(j, j));
            EXPECT_NEAR(found(i, j), expected(i, j), 1e-5 * scale) << i << " " << j;
        }
    }
}

TEST(FitResponse, NoiseIsThatOfTheFitItself) {
    for (const Smoothing& smoothing : {Smoothing{0.0, 0.0}, Smoothing{1.0, 0.7}}) {
        for (const double x : {1.7e-9, 20.3e-9, 41.5e-9}) {
            const double y = 0.6 * x;
            const RecordedScan scan(fitSurface(mapOf(1.0, [](int, int) { return 0.0; })));
            const FitResponse response(scan, smoothing, x, y);
            expectNear(response.noise(), byImpulses(smoothing, x, y));
        }
    }
}

TEST(FitResponse, HasNoLengthOfItsOwn) {
    const auto flat = [](int /*row*/, int /*column*/) { return 0.0; };
    const Smoothing smoothing{1.0, 1.0};
    const RecordedScan small(fitSurface(mapOf(1.0, flat)));
    const RecordedScan wide(fitSurface(mapOf(64.0, flat)));
    const FitResponse one(small, smoothing, 20e-9, 20e-9);
    const FitResponse large(wide, smoothing, 64.0 * 20e-9, 64.0 * 20e-9);
    EXPECT_NEAR(large.noise()(0, 0) * 64.0 * 64.0, one.noise()(0, 0), 1e-9 * one.noise()(0, 0));
    EXPECT_NEAR(large.noise()(2, 2) * std::pow(64.0, 4), one.noise()(2, 2),
                1e-9 * one.noise()(2, 2));
}

/// On a wave of the wave number q a low-pass of variance s^2 takes a share q^2 s^2 / 2.
TEST(FitResponse, TakesOutTheBlurOfAWave) {
    constexpr double kWave = 2.0 * 3.14159265358979 / 60e-9;
    HeightMap wave{.columns = 128, .rows = 8, .pitchX = 1e-9, .pitchY = 1e-9};
    for (int row = 0; row < wave.rows; ++row) {
        for (int column = 0; column < wave.columns; ++column) {
            wave.heights.push_back(1e-9 * std::cos(kWave * ((column - 63.5) * 1e-9)));
        }
    }
    const Smoothing smoothing{2.0, 2.0};
    const BSplineSurface surface = fitSurface(wave, smoothing);
    const double x = 64e-9;
    const double y = 4e-9;
    const double variance = 4e-18;
    const FitResponse response(RecordedScan(surface), smoothing, x, y);
    const double blurred = surface.at(x, y).dxx;
    const double sharp = blurred + response.sharpening({variance, variance})[2];
    const double truth = -1e-9 * kWave * kWave;
    EXPECT_NEAR(blurred / truth, 1.0 - (0.5 * kWave * kWave * variance), 1e-3);
    EXPECT_NEAR(sharp / truth, 1.0, 2e-3);
}

}  // namespace
}  // namespace asperity
