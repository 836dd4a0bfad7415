#include "app/recording/RunComparison.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace asperity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Tick {
    double time;
    double force;
};

ForceTrace traceOf(std::initializer_list<Tick> ticks) {
    ForceTrace trace;
    for (const Tick& tick : ticks) {
        trace.add(tick.time, tick.force, 0.0);
    }
    return trace;
}

/// Second run at half the rate, begun at 5 s, shorter. Interpolated: 1, 2, 3, 1, -1 at 0 ... 4 s;
/// minus 0, 1, 0, 4, 1: 1, 1, 3, -3, -2. Mean 0, rms sqrt(24 / 5), largest 3 at 2 s.
TEST(RunComparison, AgreesWithAnExampleByHand) {
    const RunComparison comparison = compareRuns(
        traceOf({{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}, {3.0, 4.0}, {4.0, 1.0}, {5.0, 9.0}}),
        traceOf({{5.0, 1.0}, {7.0, 3.0}, {9.0, -1.0}}));
    ASSERT_EQ(comparison.ticks.size(), 5U);
    EXPECT_DOUBLE_EQ(comparison.ticks[1].second, 2.0);
    EXPECT_DOUBLE_EQ(comparison.ticks[3].second, 1.0);
    EXPECT_DOUBLE_EQ(comparison.ticks[3].difference(), -3.0);
    EXPECT_DOUBLE_EQ(comparison.mean, 0.0);
    EXPECT_DOUBLE_EQ(comparison.rms, std::sqrt(24.0 / 5.0));
    EXPECT_DOUBLE_EQ(comparison.largest.difference(), 3.0);
    EXPECT_DOUBLE_EQ(comparison.largest.time, 2.0);
    EXPECT_DOUBLE_EQ(comparison.overlap, 4.0);
    EXPECT_EQ(comparison.excluded, 0U);
}

TEST(RunComparison, ExcludesAndCountsTicksWithoutAForce) {
    const RunComparison comparison = compareRuns(
        traceOf({{0.0, 0.0}, {1.0, kNaN}, {2.0, 1.0}, {3.0, 1.0}, {3.5, 1.0}, {4.0, 1.0}}),
        traceOf({{0.0, 2.0}, {1.0, 2.0}, {2.0, 2.0}, {3.0, kNaN}, {4.0, 2.0}}));
    // At 1 s the first one is not known, at 3 s the second one, at 3.5 s none is between its ticks.
    EXPECT_EQ(comparison.excluded, 3U);
    ASSERT_EQ(comparison.ticks.size(), 3U);
    EXPECT_DOUBLE_EQ(comparison.ticks[1].time, 2.0);  // beside a tick that is not known
    EXPECT_DOUBLE_EQ(comparison.mean, 4.0 / 3.0);
}

/// 0.1 + 0.2 is not 0.3: the tick is the same one all the same.
TEST(RunComparison, TakesTheTickItselfWhereTimesDifferInTheLastBits) {
    const RunComparison comparison =
        compareRuns(traceOf({{0.0, 1.0}, {0.3, 1.0}, {0.4, 1.0}}),
                    traceOf({{0.0, 1.0}, {0.1 + 0.2, 5.0}, {0.4, kNaN}}));
    ASSERT_EQ(comparison.ticks.size(), 2U);
    EXPECT_DOUBLE_EQ(comparison.ticks[1].second, 5.0);
    EXPECT_EQ(comparison.excluded, 1U);
}

TEST(RunComparison, ARunDiffersFromItselfByNothing) {
    const ForceTrace trace = traceOf({{1.0, 3.0}, {1.001, -2.0}, {1.002, 1.0}});
    const RunComparison comparison = compareRuns(trace, trace);
    EXPECT_EQ(comparison.ticks.size(), 3U);
    EXPECT_EQ(comparison.rms, 0.0);
    EXPECT_EQ(comparison.largest.difference(), 0.0);
}

TEST(RunComparison, RefusesRunsWithoutACommonForce) {
    EXPECT_THROW((void)compareRuns(traceOf({{0.0, kNaN}}), traceOf({{0.0, 1.0}})), Error);
    EXPECT_THROW((void)compareRuns(traceOf({{0.0, 1.0}}), ForceTrace()), Error);
}

TEST(ForceTrace, KnowsNoForceWhereAFaultHasSwitchedItOff) {
    TickSample sample;
    sample.output.estimate.force = Vector3(1.0, 2.0, 3.0);
    sample.output.model.normal = Vector3(0.0, 0.6, 0.8);
    sample.output.estimate.covariance = Vector3(1.0, 4.0, 9.0).asDiagonal();
    ForceTrace trace;
    trace.take(sample);
    sample.output.fault = Fault::SolverFailed;
    trace.take(sample);
    EXPECT_DOUBLE_EQ(trace.force()[0], 3.6);
    EXPECT_DOUBLE_EQ(normalForceSigma(sample.output), std::sqrt(0.36 * 4.0 + 0.64 * 9.0));
    EXPECT_TRUE(std::isnan(trace.force()[1]));
    EXPECT_TRUE(std::isnan(trace.indentation()[1]));
}

}  // namespace
}  // namespace asperity
