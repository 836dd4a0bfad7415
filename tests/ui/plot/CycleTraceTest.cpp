#include "ui/plot/CycleTrace.h"

#include "tests/core/haptics/cycle/SpringContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using test::SpringContact;

/// A spring's contact and the curve of its present cycle.
struct TracedContact : SpringContact {
    using SpringContact::SpringContact;

    void moveTo(double distance) {
        onTick = [this] { trace.take(detector); };
        SpringContact::moveTo(distance);
    }

    CycleTrace trace;
};

double strongestPull(const CycleTrace& trace) {
    double pull = 0.0;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        pull = std::max(pull, -trace[i].force);
    }
    return pull;
}

TEST(CycleTrace, HoldsBothBranchesInTheOrderOfTime) {
    TracedContact run;
    run.moveTo(-2e-9);
    run.moveTo(4e-9);
    const CycleTrace& trace = run.trace;
    ASSERT_GT(trace.size(), 100U);
    bool retracts = false;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        EXPECT_FALSE(retracts && trace[i].branch == CurveBranch::Approach);
        retracts = trace[i].branch == CurveBranch::Retract;
    }
    EXPECT_TRUE(retracts);
    EXPECT_NEAR(strongestPull(trace), SpringContact::kPull, 0.02 * SpringContact::kPull);
}

TEST(CycleTrace, PointsLieOnTheCurve) {
    TracedContact run;
    run.moveTo(-2e-9);
    run.moveTo(4e-9);
    for (std::size_t i = 0; i < run.trace.size(); ++i) {
        const TracePoint& point = run.trace[i];
        const double lever = SpringContact::kLever * (point.separation - point.baseDistance);
        EXPECT_NEAR(point.force, lever, 1e-14) << "deflection and force belong together";
    }
}

TEST(CycleTrace, ALongApproachLeavesRoomForTheContact) {
    TracedContact run;
    run.moveTo(500e-9);
    run.trace.clear();
    run.moveTo(-2e-9);
    run.moveTo(500e-9);
    std::size_t inContact = 0;
    for (std::size_t i = 0; i < run.trace.size(); ++i) {
        inContact += run.trace[i].contact ? 1 : 0;
    }
    EXPECT_LE(run.trace.size(), CycleTrace::kRoom);
    EXPECT_GT(inContact, CycleTrace::kRoom / 4);
    EXPECT_NEAR(strongestPull(run.trace), SpringContact::kPull, 0.02 * SpringContact::kPull);
}

TEST(CycleTrace, NeitherRestNorManyTurnsNeedMoreRoom) {
    TracedContact run(SpringContact::kSigma);
    for (int i = 0; i < 50; ++i) {
        run.moveTo(-2e-9);
        run.rest(1000);
        run.moveTo(0.3e-9);
    }
    EXPECT_LE(run.trace.size(), CycleTrace::kRoom);
    EXPECT_EQ(run.touches, 1);
}

}  // namespace
}  // namespace asperity
