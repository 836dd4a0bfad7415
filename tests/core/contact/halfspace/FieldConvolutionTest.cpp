#include "core/contact/halfspace/FieldConvolution.h"

#include "core/contact/halfspace/PressureSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <random>

namespace asperity {
namespace {

std::vector<double> noise(int size) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> field(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    std::generate(field.begin(), field.end(), [&] { return uniform(generator); });
    return field;
}

TEST(FieldConvolution, IsTheSumOverAllPixels) {
    for (const int size : {4, 12, 20, 36}) {
        const std::vector<double> field = noise(size);
        std::vector<double> result(field.size());
        FieldConvolution convolution = FieldConvolution::padded(size, loveInfluence);
        convolution.apply(noise(size), result);  // whatever it leaves behind
        convolution.apply(field, result);
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                double sum = 0.0;
                for (int i = 0; i < size * size; ++i) {
                    sum += loveInfluence(std::abs(row - i / size), std::abs(column - i % size)) *
                           field[static_cast<std::size_t>(i)];
                }
                EXPECT_NEAR(result[static_cast<std::size_t>(row * size + column)], sum, 1e-12);
            }
        }
    }
}

TEST(FieldConvolution, MultipliesWavesOfPeriodicFieldsByTheSymbol) {
    const int size = 24;
    FieldConvolution convolution =
        FieldConvolution::periodic(size, [](int row, int column) { return 10.0 * row + column; });
    const auto wave = [](int i) {
        const int row = i / size;
        const int column = i % size;
        return std::cos(2.0 * std::numbers::pi * (5 * row + 3 * column) / size);
    };
    std::vector<double> field;
    field.reserve(static_cast<std::size_t>(size) * size);
    for (int i = 0; i < size * size; ++i) {
        field.push_back(wave(i));
    }
    convolution.apply(field, field);
    for (int i = 0; i < size * size; ++i) {
        EXPECT_NEAR(field[static_cast<std::size_t>(i)], 53.0 * wave(i), 1e-12);
    }
}

TEST(FieldConvolution, SizesAreQuickToTransform) {
    EXPECT_EQ(fieldSize(1), 4);
    EXPECT_EQ(fieldSize(128), 128);
    EXPECT_EQ(fieldSize(129), 144);
    EXPECT_EQ(fieldSize(255), 256);
}

TEST(LoveKernel, IsAPointForceFromAfarAndBoundedOnThePixelItself) {
    EXPECT_NEAR(loveInfluence(0, 0), 4.0 * std::asinh(1.0) / std::numbers::pi, 1e-15);
    EXPECT_NEAR(loveInfluence(30, 40), 1.0 / (50.0 * std::numbers::pi), 1e-6);
    EXPECT_EQ(loveInfluence(3, 1), loveInfluence(1, 3));
}

TEST(CohesiveZone, EndsWithinAPixelWhereTheGapGrowsBeyondItsRange) {
    const int size = 16;
    std::vector<double> gaps;
    gaps.reserve(static_cast<std::size_t>(size) * size);
    for (int i = 0; i < size * size; ++i) {
        gaps.push_back(0.1 * (i % size));
    }
    for (const double range : {0.5, 0.53, 0.57}) {
        std::vector<double> shares(gaps.size());
        cohesiveShares(gaps, size, range, shares);
        double width = 0.0;
        for (int column = 0; column < size; ++column) {
            const int pixel = 5 * size + column;
            width += shares[static_cast<std::size_t>(pixel)];
        }
        EXPECT_NEAR(width - 0.5, range / 0.1, 1e-12);  // the first pixel lies on both sides of 0
    }
}

TEST(CohesiveZone, CoversAllOfAContact) {
    std::vector<double> shares(16, 0.5);
    cohesiveShares(std::vector<double>(16, 0.0), 4, 1e-9, shares);
    EXPECT_EQ(*std::min_element(shares.begin(), shares.end()), 1.0);
}

}  // namespace
}  // namespace asperity
