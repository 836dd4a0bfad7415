#include "core/Random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace asperity {
namespace {

// The reference values come from a separate Python program, which also gives the vectors that are
// published for both generators (SplitMix64 from 1234567; xoshiro256** from the state 1, 2, 3, 4).
TEST(SplitMix64, GivesThePublishedSequence) {
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected :
         {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
          16408922859458223821U}) {
        EXPECT_EQ(splitMix64(state), expected);
    }
}

TEST(Random, GivesTheReferenceSequence) {
    Random fromZero(0);
    for (const std::uint64_t expected :
         {0x99ec5f36cb75f2b4U, 0xbf6e1f784956452aU, 0x1a5f849d4933e6e0U, 0x6aa594f1262d2d2cU}) {
        EXPECT_EQ(fromZero.bits(), expected);
    }
    Random other(42);
    for (const std::uint64_t expected :
         {0x15780b2e0c2ec716U, 0x6104d9866d113a7eU, 0xae17533239e499a1U, 0xecb8ad4703b360a1U}) {
        EXPECT_EQ(other.bits(), expected);
    }
}

TEST(Random, UniformUsesTheUpperBits) {
    Random random(42);
    EXPECT_EQ(random.uniform(), 0.08386297105988216);
}

TEST(Random, NormalPairIsThatOfBoxAndMuller) {
    Random random(42);
    EXPECT_DOUBLE_EQ(random.normal(), -0.303263064678738);
    EXPECT_DOUBLE_EQ(random.normal(), 0.28846173882942383);
}

TEST(Random, ACopyContinuesWithTheSameNumbers) {
    Random random(9);
    (void)random.normal();  // leaves the second of a pair pending
    Random copy = random;
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(random.normal(), copy.normal());
    }
}

TEST(Random, UniformStaysInItsRangeWithTheRightMean) {
    Random random(3);
    double sum = 0.0;
    constexpr int kDraws = 100000;
    for (int i = 0; i < kDraws; ++i) {
        const double value = random.uniform(-2.0, 6.0);
        ASSERT_GE(value, -2.0);
        ASSERT_LT(value, 6.0);
        sum += value;
    }
    EXPECT_NEAR(sum / kDraws, 2.0, 5.0 * 8.0 / std::sqrt(12.0 * kDraws));
}

TEST(Random, NormalHasTheMomentsOfANormalDistribution) {
    Random random(4);
    constexpr int kDraws = 100000;
    std::array<double, 3> moments{};
    for (int i = 0; i < kDraws; ++i) {
        const double value = random.normal();
        moments[0] += value / kDraws;
        moments[1] += value * value / kDraws;
        moments[2] += value * value * value * value / kDraws;
    }
    const double error = 5.0 / std::sqrt(kDraws);
    EXPECT_NEAR(moments[0], 0.0, error);
    EXPECT_NEAR(moments[1], 1.0, std::sqrt(2.0) * error);
    EXPECT_NEAR(moments[2], 3.0, std::sqrt(96.0) * error);
}

}  // namespace
}  // namespace asperity
