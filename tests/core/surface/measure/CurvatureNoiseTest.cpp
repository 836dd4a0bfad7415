#include "core/surface/measure/CurvatureNoise.h"

#include "core/Random.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

constexpr int kNoisySide = 160;
constexpr double kNoisyPitch = 1e-9;   // [m]
constexpr double kScanNoise = 30e-12;  // of each height [m]
constexpr ScanSize kNoisyScan{kNoisySide, kNoisySide, kNoisySide* kNoisyPitch,
                              kNoisySide* kNoisyPitch};

/// Noise that follows what was before it along each row, as a feedback loop leaves it.
/// @param memory 0: white
HeightMap noiseMap(double memory, std::uint64_t seed) {
    HeightMap map = flatMap(kNoisyScan);
    Random random(seed);
    for (int row = 0; row < map.rows; ++row) {
        double value = random.normal();
        for (int column = 0; column < map.columns; ++column) {
            value = (memory * value) + (std::sqrt(1.0 - (memory * memory)) * random.normal());
            map.heights[map.index(row, column)] = kScanNoise * value;
        }
    }
    return map;
}

HeightMap sumOf(HeightMap map, const HeightMap& other) {
    std::ranges::transform(map.heights, other.heights, map.heights.begin(), std::plus<>());
    return map;
}

/// Standard deviation of the mean curvature at pixels' centers, away from the edges [1/m].
double curvatureSpread(const HeightMap& map, const Smoothing& smoothing) {
    constexpr int kEdge = 20;
    const BSplineSurface surface = fitSurface(map, smoothing);
    double sum = 0.0;
    int count = 0;
    for (int row = kEdge; row < map.rows - kEdge; ++row) {
        for (int column = kEdge; column < map.columns - kEdge; ++column) {
            const HeightSample sample =
                surface.at((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY);
            const double mean = 0.5 * (sample.dxx + sample.dyy);
            sum += mean * mean;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

const EggBox kHills{.amplitude = 4e-9, .periodX = 80e-9, .periodY = 80e-9};

TEST(CurvatureNoise, IsThatOfTheFitWhateverTheNoiseAndTheShape) {
    const HeightMap hills = sampledMap(kNoisyScan, kHills);
    for (const double memory : {0.0, 0.5, 0.8}) {
        const HeightMap noise = noiseMap(memory, 5);
        const CurvatureNoise alone(noise);
        const CurvatureNoise onHills(sumOf(hills, noise));
        for (const double pixels : {0.0, 0.6, 1.0, 2.0}) {
            const Smoothing smoothing{pixels, pixels};
            const double truth = curvatureSpread(noise, smoothing);
            EXPECT_NEAR(alone.noise(smoothing), truth, 0.15 * truth) << memory << " " << pixels;
            EXPECT_NEAR(onHills.noise(smoothing), truth, 0.15 * truth) << memory << " " << pixels;
        }
    }
}

double whiteNoise(const CurvatureNoise& scan, const Smoothing& smoothing) {
    return scan.heightNoise(smoothing, scan.noise(smoothing));
}

/// sqrt(2 / pi) / (4 s^3) of the noise over the pitch squared, in the continuum; the spline's
/// second derivative is 1 + (k p)^2 / 12 of that, which at 1 / (s p) is a hundredth for 3 pixels.
TEST(CurvatureNoise, OfKnownWhiteNoiseIsTheClosedForm) {
    const CurvatureNoise scan(flatMap(kNoisyScan), kScanNoise);
    for (const double pixels : {3.0, 6.0}) {
        const double expected = std::sqrt(2.0 / std::numbers::pi) / (4.0 * std::pow(pixels, 3)) *
                                kScanNoise / (kNoisyPitch * kNoisyPitch);
        EXPECT_NEAR(scan.noise({pixels, pixels}), expected, 0.03 * expected) << pixels;
        EXPECT_NEAR(whiteNoise(scan, {pixels, pixels}), kScanNoise, 1e-9 * kScanNoise);
    }
}

/// Rows that a feedback loop has filtered hold less of the highest frequencies, and not less of
/// those that curvatures are made of.
TEST(CurvatureNoise, IsNotFooledByNoiseThatIsFiltered) {
    const Smoothing smoothing{1.0, 1.0};
    EXPECT_NEAR(whiteNoise(CurvatureNoise(noiseMap(0.0, 3)), smoothing), kScanNoise,
                0.1 * kScanNoise);
    const HeightMap filtered = noiseMap(0.7, 3);
    EXPECT_LT(heightNoise(filtered), 0.6 * kScanNoise) << "by the highest frequencies alone";
    EXPECT_GT(whiteNoise(CurvatureNoise(filtered), smoothing), kScanNoise);
}

TEST(CurvatureNoise, IsNextToNoneOnASmoothSurface) {
    const CurvatureNoise scan(sampledMap(kNoisyScan, kHills));
    EXPECT_LT(whiteNoise(scan, {}), 1e-3 * kScanNoise);
}

/// exp(-u) - exp(-2 u) of a wave's curvature, u the variance over the square of 1 / k.
TEST(CurvatureNoise, BlurIsWhatTwiceTheVarianceTakesMore) {
    constexpr double kWave = 2.0 * std::numbers::pi;
    // No two pixels are at the same phase.
    const EggBox waves{.amplitude = 1e-9, .periodX = 16.6e-9, .periodY = 15.3e-9};
    const double square = 0.5 * (std::pow(kWave / waves.periodX, 2) +  // of k along an axis
                                 std::pow(kWave / waves.periodY, 2));
    const CurvatureNoise scan(sampledMap(kNoisyScan, waves));
    std::vector<double> curvatures;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 200; ++j) {
            const HeightSample sample =
                waves.at(waves.periodX * (i + 0.5) / 200.0, waves.periodY * (j + 0.5) / 200.0);
            curvatures.push_back(0.5 * std::abs(sample.dxx + sample.dyy));
        }
    }
    std::ranges::nth_element(curvatures, curvatures.begin() + 20000);
    for (const double pixels : {1.0, 2.0}) {
        const double u = std::pow(pixels * kNoisyPitch, 2) * square;
        const double expected = curvatures[20000] / 0.6745 * (std::exp(-u) - std::exp(-2.0 * u));
        EXPECT_NEAR(scan.blur({pixels, pixels}, 0.0), expected, 0.05 * expected) << pixels;
    }
}

TEST(CurvatureNoise, ScalesWithAllLengths) {
    const HeightMap map = sumOf(sampledMap(kNoisyScan, kHills), noiseMap(0.3, 9));
    HeightMap large = map;
    large.pitchX *= 64.0;
    large.pitchY *= 64.0;
    for (double& height : large.heights) {
        height *= 64.0;
    }
    const Smoothing smoothing{1.0, 1.0};
    const CurvatureNoise one(map);
    const CurvatureNoise other(large);
    const double noise = one.noise(smoothing);
    EXPECT_DOUBLE_EQ(64.0 * other.noise(smoothing), noise);
    EXPECT_DOUBLE_EQ(64.0 * other.blur(smoothing, noise / 64.0), one.blur(smoothing, noise));
}

TEST(CurvatureNoise, LeavesOutWhatHasNoDataAndTakesSmallScans) {
    HeightMap map = noiseMap(0.0, 4);
    const double whole = CurvatureNoise(map).noise({1.0, 1.0});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 40; column < 60; ++column) {
            map.heights[map.index(row, column)] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    EXPECT_NEAR(CurvatureNoise(map).noise({1.0, 1.0}), whole, 0.15 * whole);
    std::ranges::fill(map.heights, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(CurvatureNoise(map).noise({1.0, 1.0}), 0.0);
    for (const int columns : {1, 3}) {
        const CurvatureNoise line(flatMap({columns, 1, 1e-9, 1e-9}));
        EXPECT_EQ(line.noise({1.0, 1.0}), 0.0);
        EXPECT_EQ(line.blur({1.0, 1.0}, 0.0), 0.0);
    }
}

}  // namespace
}  // namespace asperity
