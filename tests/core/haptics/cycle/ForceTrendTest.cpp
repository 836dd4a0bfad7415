#include "core/haptics/cycle/ForceTrend.h"

#include "core/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// An estimate that weights its model by the signals claims little where they happen to agree. A
/// line whose memory is held has 0.72 of the variance of one through its ticks alone.
TEST(ForceTrend, ItsDeviationIsThatOfAllItsTicks) {
    Random random(3);
    ForceTrend trend;
    int sure = 0;
    double squares = 0.0;
    constexpr int kTicks = 50000;
    for (int i = 0; i < kTicks; ++i) {
        const double noise = random.normal();
        trend.take(kSigma * noise, kSigma * std::max(0.1, std::abs(noise)));
        sure += trend.pushes() || trend.pulls() ? 1 : 0;
        squares += trend.force() * trend.force() / (trend.sigma() * trend.sigma());
    }
    EXPECT_EQ(sure, 0);
    EXPECT_NEAR(squares / kTicks, 0.72, 0.1);
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

/// A fast touch: the force bends within fewer ticks than the line has.
TEST(ForceTrend, APeakIsNotBeyondEachTick) {
    for (const double sign : {1.0, -1.0}) {
        ForceTrend trend;
        double line = 0.0;
        double peak = 0.0;
        for (int i = 0; i < 40; ++i) {
            trend.take(sign * std::min(4.0 * kSigma * i, 30.0 * 4.0 * kSigma), kSigma);
            line = std::max(line, sign * trend.force());
            peak = std::max(peak, sign > 0.0 ? trend.push() : trend.pull());
        }
        EXPECT_GT(line, 1.002 * 120.0 * kSigma) << "the line goes beyond";
        EXPECT_NEAR(peak, 120.0 * kSigma, 1e-12);
    }
}

/// The largest that the trend shows after a jump of this many standard deviations, over it.
double overshootOf(double jump) {
    ForceTrend trend;
    for (int i = 0; i < 200; ++i) {
        trend.take(0.0, kSigma);
    }
    double largest = 0.0;
    for (int i = 0; i < 100; ++i) {
        trend.take(jump * kSigma, kSigma);
        largest = std::max(largest, trend.force());
    }
    return largest / (jump * kSigma) - 1.0;
}

TEST(ForceTrend, DoesNotOvershootAtAJumpOfAFewStandardDeviations) {
    for (const double jump : {3.0, 3.4, 4.0, 5.0, 6.0, 7.0}) {
        EXPECT_LT(overshootOf(jump), 1e-9) << jump;
    }
}

/// The force of a hand that trembles bends all the time: noise is no less averaged than by a line.
TEST(ForceTrend, ABendIsNoJump) {
    Random random(11);
    ForceTrend trend;
    int anew = 0;
    constexpr int kTicks = 20000;
    for (int i = 0; i < kTicks; ++i) {
        const double tremor = 3.0 * kSigma * std::sin(0.06 * i);  // 10 Hz at 1 kHz
        trend.take(tremor + kSigma * random.normal(), kSigma);
        anew += trend.sigma() > 0.43 * kSigma ? 1 : 0;
    }
    EXPECT_LT(anew, kTicks / 20);
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
