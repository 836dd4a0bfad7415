#include "core/Random.h"
#include "core/haptics/cycle/CycleDetector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// A pull tick by tick, in standard deviations of a tick.
struct Pull {
    std::string name;
    int ticks = 0;
    std::function<double(int)> at;
};

/// How far the reading is from the strongest pull, in its own stated standard deviations, over many
/// runs: mean and root mean square about it.
struct Scatter {
    double bias = 0.0;
    double spread = 0.0;
};

Scatter scatterOf(const Pull& pull, Random& random) {
    constexpr int kRuns = 600;
    double strongest = 0.0;
    for (int i = 0; i < pull.ticks; ++i) {
        strongest = std::max(strongest, pull.at(i));
    }
    double sum = 0.0;
    double squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        ForceTrend trend;
        StrongestForce peak(StrongestForce::kGrowing);
        for (int i = 0; i < pull.ticks; ++i) {
            trend.take(-pull.at(i) + random.normal(), 1.0);
            if (trend.pulls()) {
                (void)peak.take(trend.halves(-1.0), trend.pull());
            }
        }
        const Reading reading = peak.reading().value();
        const double off = (reading.value - strongest) / reading.sigma;
        sum += off;
        squares += off * off;
    }
    const double bias = sum / kRuns;
    return {bias, std::sqrt(squares / kRuns - bias * bias)};
}

/// The largest of as many noisy values lies 0.9 to 2.3 of these standard deviations too high.
TEST(StrongestForce, IsNotBiasedByNoise) {
    Random random(6);
    const std::vector<Pull> pulls{
        {"held at its strongest", 300, [](int) { return 20.0; }},
        {"ramp of 0.02", 1000, [](int i) { return 0.02 * i; }},
        {"ramp of 0.1", 300, [](int i) { return 0.1 * i; }},
        {"fold", 1000, [](int i) { return 20.0 * (1.0 - std::pow(1.0 - i / 999.0, 2.0)); }},
        {"strongest before the pull-off", 400,
         [](int i) { return 20.0 * (1.0 - std::pow((i - 250) / 250.0, 2.0)); }}};
    for (const Pull& pull : pulls) {
        SCOPED_TRACE(pull.name);
        const Scatter scatter = scatterOf(pull, random);
        EXPECT_LT(std::abs(scatter.bias), 0.3);
        EXPECT_GT(scatter.spread, 0.7);
        EXPECT_LT(scatter.spread, 1.2);
        std::printf("%s: bias %.2f, spread %.2f of the stated standard deviation\n",
                    pull.name.c_str(), scatter.bias, scatter.spread);
    }
}

TEST(StrongestForce, WithoutNoiseIsTheStrongestTick) {
    ForceTrend trend;
    StrongestForce peak(StrongestForce::kSudden);
    for (const double pull : {1.0, 2.0, 3.5, 5.0, 4.0, 0.0, -3.0}) {
        trend.take(-pull, 0.0);
        (void)peak.take(trend.halves(-1.0), trend.pull());
    }
    EXPECT_EQ(peak.reading().value().value, 5.0);
    EXPECT_EQ(peak.reading().value().sigma, 0.0);
}

TEST(StrongestForce, IsNoneBeforeATick) {
    EXPECT_FALSE(StrongestForce(StrongestForce::kSudden).reading());
}

}  // namespace
}  // namespace asperity
