#include "core/haptics/cycle/ForceTrend.h"

#include "core/Random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kSigma = 0.1;

TEST(ForceTrend, FollowsARampWithoutLag) {
    ForceTrend trend;
    for (int i = 0; i <= 200; ++i) {
        trend.take(0.05 * i, kSigma);
    }
    EXPECT_NEAR(trend.force(), 10.0, 1e-9);
}

TEST(ForceTrend, StartsAnewAtAJump) {
    ForceTrend trend;
    for (int i = 0; i < 50; ++i) {
        trend.take(-18.0, kSigma);
    }
    trend.take(-0.2, kSigma);
    EXPECT_EQ(trend.force(), -0.2);
    EXPECT_EQ(trend.sigma(), kSigma);
}

TEST(ForceTrend, NoiseIsLessAndKnown) {
    Random random(7);
    ForceTrend trend;
    double sum = 0.0;
    constexpr int kTicks = 20000;
    for (int i = 0; i < kTicks; ++i) {
        trend.take(kSigma * random.normal(), kSigma);
        sum += trend.force() * trend.force();
    }
    const double scatter = std::sqrt(sum / kTicks);
    EXPECT_LT(trend.sigma(), 0.43 * kSigma);
    EXPECT_LT(scatter, 1.05 * trend.sigma()) << "never surer than it may be";
    EXPECT_GT(scatter, 0.7 * trend.sigma());
}

TEST(ForceTrend, NoiseNeitherPushesNorPulls) {
    Random random(3);
    ForceTrend trend;
    long alarms = 0;
    for (int i = 0; i < 2000000; ++i) {
        trend.take(kSigma * random.normal(), kSigma);
        alarms += trend.pushes() || trend.pulls() ? 1 : 0;
    }
    EXPECT_EQ(alarms, 0) << "in half an hour at 1 kHz";
}

TEST(ForceTrend, AForceOfThreeStandardDeviationsShowsSoon) {
    Random random(5);
    ForceTrend trend;
    int seen = 0;
    for (int i = 0; i < 1000; ++i) {
        trend.take(kSigma * (3.0 + random.normal()), kSigma);
        seen += trend.pushes() ? 1 : 0;
    }
    EXPECT_GT(seen, 900);
}

}  // namespace
}  // namespace asperity
