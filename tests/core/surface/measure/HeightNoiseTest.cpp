#include "core/Random.h"
#include "core/surface/measure/CurvatureNoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr int kSide = 128;
constexpr double kPitch = 1e-9;    // [m]
constexpr double kNoise = 30e-12;  // [m]

/// A sphere of 500 nm, a step and noise.
HeightMap noisySphere(double noise, double step) {
    HeightMap map{.columns = kSide, .rows = kSide, .pitchX = kPitch, .pitchY = kPitch};
    Random random(7);
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            const double x = (column - 63.5) * kPitch;
            const double y = (row - 63.5) * kPitch;
            const double sphere = std::sqrt((500e-9 * 500e-9) - (x * x) - (y * y));
            map.heights.push_back(sphere + (noise * random.normal()) + (x > 20e-9 ? step : 0.0));
        }
    }
    return map;
}

TEST(HeightNoise, IsThatOfTheHeightsWhateverTheShape) {
    // Of 15,000 positions, each third of them independent, the median is good to 2 %.
    EXPECT_NEAR(heightNoise(noisySphere(kNoise, 0.0)), kNoise, 0.06 * kNoise);
    EXPECT_NEAR(heightNoise(noisySphere(kNoise, 20e-9)), kNoise, 0.08 * kNoise);
    EXPECT_LT(heightNoise(noisySphere(0.0, 0.0)), 1e-4 * kNoise);
}

TEST(HeightNoise, ScalesWithTheHeights) {
    HeightMap map = noisySphere(kNoise, 0.0);
    const double before = heightNoise(map);
    for (double& height : map.heights) {
        height *= 64.0;
    }
    EXPECT_DOUBLE_EQ(heightNoise(map), 64.0 * before);
}

TEST(HeightNoise, LeavesOutWhatHasNoData) {
    HeightMap map = noisySphere(kNoise, 0.0);
    map.invalid.assign(map.heights.size(), false);
    for (int row = 0; row < kSide; ++row) {
        map.invalid[map.index(row, 40)] = true;
        map.heights[map.index(row, 90)] = std::numeric_limits<double>::quiet_NaN();
    }
    EXPECT_NEAR(heightNoise(map), kNoise, 0.06 * kNoise);
    map.rows = 4;
    map.heights.resize(static_cast<std::size_t>(4) * kSide);
    map.invalid.clear();
    EXPECT_EQ(heightNoise(map), 0.0);
}

}  // namespace
}  // namespace asperity
