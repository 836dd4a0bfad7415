#include "core/experiment/StudyStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

TEST(Estimate, HasStudentsInterval) {
    const std::vector<double> values{1.0, 2.0, 3.0};
    const Estimate estimate = estimateOf(values);
    EXPECT_EQ(estimate.count, 3U);
    EXPECT_DOUBLE_EQ(estimate.mean, 2.0);
    EXPECT_DOUBLE_EQ(estimate.deviation, 1.0);
    // t of 2 degrees of freedom: 0.95 sqrt(2 / (1 - 0.95^2)).
    const double t = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95));
    EXPECT_NEAR(estimate.high - 2.0, t / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(2.0 - estimate.low, t / std::sqrt(3.0), 1e-12);
}

TEST(Estimate, ASingleValueHasNoInterval) {
    const std::vector<double> values{4.0};
    const Estimate estimate = estimateOf(values);
    EXPECT_EQ(estimate.mean, 4.0);
    EXPECT_TRUE(std::isnan(estimate.low) && std::isnan(estimate.high));
    EXPECT_FALSE(estimate.isAbove(0.0) || estimate.isBelow(0.0));
}

TEST(Estimate, CorrelationHasFishersInterval) {
    const std::vector<double> x{1.0, 2.0, 3.0, 4.0};
    const std::vector<double> y{1.0, 3.0, 2.0, 4.0};
    const Estimate relation = correlationOf(x, y);
    EXPECT_NEAR(relation.mean, 0.8, 1e-15);
    EXPECT_NEAR(std::atanh(relation.high) - std::atanh(relation.mean), 1.959963984540054, 1e-12);
    EXPECT_NEAR(std::atanh(relation.mean) - std::atanh(relation.low), 1.959963984540054, 1e-12);
    EXPECT_TRUE(std::isnan(correlationOf(std::vector{1.0, 1.0, 1.0, 1.0}, y).mean));
}

TEST(Estimate, SlopeIsThatOfTheLine) {
    const std::vector<double> x{1.0, 2.0, 3.0};
    const std::vector<double> line{5.0, 3.0, 1.0};
    EXPECT_DOUBLE_EQ(slopeOf(x, line), -2.0);
    EXPECT_TRUE(std::isnan(slopeOf(std::vector{1.0, 1.0}, std::vector{1.0, 2.0})));
}

}  // namespace
}  // namespace asperity
