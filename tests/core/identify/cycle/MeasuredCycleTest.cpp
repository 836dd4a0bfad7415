#include "core/identify/cycle/MeasuredCycle.h"

#include "core/Error.h"
#include "core/identify/cycle/CycleResiduals.h"
#include "tests/core/identify/cycle/CycleFiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

TEST(MeasuredCycle, FindsBothJumpsUnderNoise) {
    for (const double noise : {1e-4, 1e-3, 1e-2}) {
        const MeasuredCycle cycle = test::syntheticCycle("jkr_two", noise);
        const CycleEvents events = cycleEvents(cycle);
        const double step = cycle.approach.base[1] - cycle.approach.base[0];
        ASSERT_TRUE(events.snapIn.has_value());
        EXPECT_NEAR(events.snapIn->base, 0.0, step);
        ASSERT_TRUE(events.pullOff.has_value());
        EXPECT_EQ(events.pullOff->before + 1, events.pullOff->after);
        EXPECT_LT(cycle.retract.force[events.pullOff->before], 0.8 * events.lowestForce);
        EXPECT_NEAR(cycle.retract.force[events.pullOff->after], 0.0, 5.0 * cycle.noise);
        EXPECT_TRUE(events.attracts);
    }
}

TEST(MeasuredCycle, WithoutAdhesionContactIsWhereTheForceRises) {
    const MeasuredCycle cycle = test::syntheticCycle("relaxing_slow", 1e-4);
    const CycleEvents events = cycleEvents(cycle);
    EXPECT_FALSE(events.snapIn.has_value());
    EXPECT_FALSE(events.pullOff.has_value());
    EXPECT_FALSE(events.attracts);
    EXPECT_NEAR(cycle.approach.base[events.contactBegin], 0.0, 0.1e-6);
}

TEST(MeasuredCycle, HasNoContactInNoise) {
    MeasuredCycle cycle = test::syntheticCycle("jkr_one", 1e-4);
    cycle.approach.force.assign(cycle.approach.size(), 0.0);
    EXPECT_THROW((void)cycleEvents(cycle), Error);
    cycle.retract = {};
    EXPECT_THROW((void)cycleEvents(cycle), Error);
}

TEST(CycleBranch, BinsKeepTheMean) {
    CycleBranch branch;
    for (int i = 0; i < 1003; ++i) {
        branch.base.push_back(i);
        branch.force.push_back(2.0 * i);
    }
    const CycleBranch few = binned(branch, 3, 1003, 10);
    ASSERT_EQ(few.size(), 10U);
    EXPECT_NEAR(few.base[0], 52.5, 1e-12);
    EXPECT_NEAR(few.force[9], 2.0 * 952.5, 1e-9);
    EXPECT_NEAR(contactSlope(few), 2.0, 1e-12);
    EXPECT_EQ(binned(branch, 0, 4, 10).size(), 4U);
}

/// Simulated forces that are wrong by a share of the range, and by much within the margin of the
/// snap-in.
TEST(CycleResiduals, AreSharesOfTheRangeAndLeaveOutTheJumps) {
    MeasuredCycle cycle = test::syntheticCycle("jkr_one");
    const CycleEvents events = cycleEvents(cycle);
    const double range = cycle.forceRange();
    SimulatedCycle forces{cycle.approach.force, {}, cycle.retract.force};
    for (double& force : forces.approach) {
        force += 0.01 * range;
    }
    cycle.approach.base[events.snapIn->after] = events.snapIn->base;
    forces.approach[events.snapIn->after] += range;
    const CycleResiduals rms = cycleResiduals(cycle, events, forces, forces);
    EXPECT_NEAR(rms.approachContact, 0.01, 1e-12);
    EXPECT_EQ(rms.retractContact, 0.0);
    EXPECT_NEAR(rms.cycle, 0.01 / std::sqrt(2.0), 1e-4);
    EXPECT_GT(rms.cycleWithJumps, 0.03);
}

}  // namespace
}  // namespace asperity
