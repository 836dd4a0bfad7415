#include "core/realtime/PacedThread.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LatencyHistogram, SaysZeroOfNothing) {
    const LatencyHistogram histogram;
    EXPECT_EQ(histogram.quantile(0.99), 0.0);
    EXPECT_EQ(histogram.quantiles().largest, 0.0);
}

TEST(LatencyHistogram, QuantilesAreWithinASixteenth) {
    LatencyHistogram histogram;
    for (int i = 1; i <= 1000; ++i) {
        histogram.add(i * 1e-6);
    }
    for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99}) {
        const double exact = share * 1e-3;
        EXPECT_GE(histogram.quantile(share), exact * (1.0 - 1e-9));
        EXPECT_LE(histogram.quantile(share), exact * (1.0 + 1.0 / 16.0));
    }
    EXPECT_DOUBLE_EQ(histogram.quantiles().largest, 1e-3);
}

TEST(LatencyHistogram, TakesAnyTime) {
    LatencyHistogram histogram;
    histogram.add(-1.0);
    histogram.add(0.0);
    histogram.add(3e-9);
    histogram.add(1e6);
    EXPECT_EQ(histogram.count(), 4U);
    EXPECT_EQ(histogram.quantile(0.25), 0.0);
    EXPECT_DOUBLE_EQ(histogram.quantile(0.75), 3e-9);
    EXPECT_DOUBLE_EQ(histogram.quantiles().largest, 1e6);
}

TEST(LatencyHistogram, AddsUp) {
    LatencyHistogram fast;
    LatencyHistogram slow;
    for (int i = 0; i < 99; ++i) {
        fast.add(10e-9);
    }
    slow.add(1e-3);
    fast.add(slow);
    EXPECT_EQ(fast.count(), 100U);
    EXPECT_DOUBLE_EQ(fast.quantile(0.99), 10e-9);
    EXPECT_DOUBLE_EQ(fast.quantile(1.0), 1e-3);
}

TEST(LatencyHistogram, ForgetsWhenCleared) {
    LatencyHistogram histogram;
    histogram.add(1.0);
    histogram.clear();
    EXPECT_EQ(histogram.count(), 0U);
    EXPECT_EQ(histogram.quantiles().largest, 0.0);
}

}  // namespace
}  // namespace asperity
