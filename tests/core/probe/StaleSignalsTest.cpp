#include "core/probe/InnovationMonitor.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(StaleSignals, AreNotStaleWhenTheyAreOfNow) {
    SignalHistory memory;
    for (int i = 0; i < 5; ++i) {
        const LeverSignals staleness = stalenessOf({1e-6 * i, -1e-6 * i}, 0.0, 1e-3, memory);
        EXPECT_EQ(staleness.bending, 0.0);
        EXPECT_EQ(staleness.torsion, 0.0);
    }
}

/// A steady change of 1 urad/ms makes signals of 20 ms ago doubtful by 20 urad.
TEST(StaleSignals, MayBeOffByWhatTheModelExpectsMeanwhile) {
    SignalHistory memory;
    LeverSignals staleness;
    for (int i = 0; i < 100; ++i) {
        staleness = stalenessOf({1e-6 * i, -2e-6 * i}, 20e-3, 1e-3, memory);
    }
    EXPECT_NEAR(staleness.bending, 20e-6, 1e-6);
    EXPECT_NEAR(staleness.torsion, 40e-6, 2e-6);
}

TEST(StaleSignals, AreTrustedAgainOnceNothingHasChangedForAFewAges) {
    SignalHistory memory;
    (void)stalenessOf({}, 20e-3, 1e-3, memory);
    EXPECT_NEAR(stalenessOf({1e-4, 0.0}, 20e-3, 1e-3, memory).bending, 1e-4, 1e-9)
        << "it has snapped in: no more than this can have changed, however long a tick is";
    LeverSignals staleness;
    for (int i = 0; i < 300; ++i) {
        staleness = stalenessOf({1e-4, 0.0}, 20e-3, 1e-3, memory);
    }
    EXPECT_LT(staleness.bending, 1e-9);
}

}  // namespace
}  // namespace asperity
