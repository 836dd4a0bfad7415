#include "core/probe/recorded/RecordedAfm.h"

#include "core/probe/CantileverModes.h"
#include "core/surface/deformation/ContactHeight.h"
#include "core/surface/fit/BSplineFit.h"
#include "tests/core/probe/recorded/AdhesiveCycle.h"
#include "tests/support/AllocationCounter.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kTip = 15e-9;  // [m]

/// An instrument over a surface.
struct Recorded {
    explicit Recorded(const HeightMap& map) : surface(fitSurface(map)) {}

    [[nodiscard]] AfmMeasurement at(double x, double y, double z) {
        return afm.exchange({.position = {x, y, z}, .velocity = Vector3::Zero()});
    }
    [[nodiscard]] double forceOf(const AfmMeasurement& measured) const {
        return measured.signals.bending / leverSignals(lever, Vector3::UnitZ()).bending;
    }

    BSplineSurface surface;
    Cantilever lever{test::plainScene().probe};
    std::shared_ptr<const PlayedCurve> curve = playedCurve(test::adhesiveCycle(), 0.0);
    RecordedAfm afm{curve, surface, kTip, lever};
};

TEST(RecordedAfm, GivesTheRecordedSamplesAsTheSameBitsInEachRun) {
    Recorded one(test::flatMap());
    Recorded other(test::flatMap());
    const auto play = [&](const PlayedBranch& branch, std::size_t first) {
        for (std::size_t i = first; i < branch.force.size(); ++i) {
            const std::size_t before = test::allocationCount();
            const AfmMeasurement measured = one.at(64e-9, 64e-9, branch.distance[i]);
            ASSERT_EQ(test::allocationCount(), before);
            const Vector3 force(0.0, 0.0, branch.force[i]);
            ASSERT_EQ(measured.signals.bending, leverSignals(one.lever, force).bending) << i;
            ASSERT_EQ(measured.signals.torsion, 0.0);
            ASSERT_TRUE(measured.connected && measured.age == 0.0);
            ASSERT_FALSE(measured.extrapolated || measured.aside || measured.ended) << i;
            const AfmMeasurement again = other.at(64e-9, 64e-9, branch.distance[i]);
            ASSERT_EQ(again.signals.bending, measured.signals.bending);
        }
    };
    play(one.curve->approach, 0);
    play(one.curve->retract, 1);
}

TEST(RecordedAfm, KnowsTheSamplesOnAHillWhereTheBaseIsRounded) {
    Recorded hilly(test::hillyMap());
    const double touch = tipContactHeight(hilly.surface, 40e-9, 70e-9, kTip) - kTip;
    const PlayedBranch& approach = hilly.curve->approach;
    for (std::size_t i = 0; i < approach.force.size(); ++i) {
        const AfmMeasurement measured = hilly.at(40e-9, 70e-9, touch + approach.distance[i]);
        const Vector3 force(0.0, 0.0, approach.force[i]);
        ASSERT_EQ(measured.signals.bending, leverSignals(hilly.lever, force).bending) << i;
    }
}

TEST(RecordedAfm, HasTheRecordedContactWhereTheTipFirstTouches) {
    constexpr double kSlope = 0.3;
    constexpr double kX = 50e-9;
    const double touch = kSlope * kX + kTip * (std::sqrt(1.0 + kSlope * kSlope) - 1.0);
    Recorded sloped(test::slopedMap(kSlope));
    (void)sloped.at(80e-9, 64e-9, touch + 60e-9);
    for (double d = 40e-9; d > 10e-9; d -= 0.5e-9) {
        EXPECT_FALSE(sloped.at(kX + d, 64e-9, touch + kSlope * d + d).aside);
    }
    (void)sloped.at(kX, 64e-9, touch + 1e-9);
    for (const double depth : {0.0, 5e-9, 10e-9}) {
        EXPECT_NEAR(sloped.forceOf(sloped.at(kX, 64e-9, touch - depth)),
                    test::kCycleStiffness * depth, 0.15e-9);
    }
}

TEST(RecordedAfm, TellsABaseThatIsBesideTheFirstTouch) {
    Recorded flat(test::flatMap());
    EXPECT_FALSE(flat.at(40e-9, 40e-9, 50e-9).aside);
    EXPECT_FALSE(flat.at(64e-9, 64e-9, 50e-9).aside) << "not touched yet";
    EXPECT_FALSE(flat.at(64e-9, 64e-9, -2e-9).aside);
    const double limit = RecordedAfm::kAside * kTip;
    EXPECT_FALSE(flat.at(64e-9 + 0.99 * limit, 64e-9, -2e-9).aside);
    const AfmMeasurement aside = flat.at(64e-9, 64e-9 - 1.01 * limit, -2e-9);
    EXPECT_TRUE(aside.aside);
    EXPECT_NEAR(flat.forceOf(aside), test::kCycleStiffness * 2e-9, 0.1e-9);
    EXPECT_TRUE(flat.at(30e-9, 30e-9, 250e-9).aside) << "the record stays where it is";
}

TEST(RecordedAfm, EndsBelowTheRecordAndIsBackAboveItsEnd) {
    Recorded flat(test::flatMap());
    (void)flat.at(64e-9, 64e-9, 10e-9);
    EXPECT_FALSE(flat.at(64e-9, 64e-9, flat.curve->approach.distance.back()).ended);
    const AfmMeasurement ended = flat.at(64e-9, 64e-9, -1.5 * test::kCycleDeepest);
    EXPECT_TRUE(ended.ended);
    EXPECT_FALSE(ended.connected);
    EXPECT_TRUE(flat.at(64e-9, 64e-9, 0.0).connected);
}

TEST(RecordedAfm, ABaseThatIsNoNumberIsAnswered) {
    Recorded flat(test::flatMap());
    EXPECT_FALSE(flat.at(64e-9, 64e-9, std::nan("")).connected);
    EXPECT_TRUE(flat.at(64e-9, 64e-9, 10e-9).connected);
}

}  // namespace
}  // namespace asperity
