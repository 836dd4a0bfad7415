#include "core/probe/recorded/CurvePlayer.h"

#include "core/Error.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/probe/recorded/AdhesiveCycle.h"
#include "tests/support/ReferenceTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using testing::HasSubstr;

/// Differs between its neighbors at most [N].
double largestStep(const PlayedBranch& branch) {
    double largest = 0.0;
    for (std::size_t i = 1; i < branch.force.size(); ++i) {
        largest = std::max(largest, std::abs(branch.force[i] - branch.force[i - 1]));
    }
    return largest;
}

class PlayedCycle : public testing::Test {
protected:
    /// Moves in steps, and leaves the largest change of the force in `jump_`.
    PlayedForce move(double to) {
        constexpr double kSmall = 0.01e-9;
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - at_) / kSmall)));
        PlayedForce played;
        for (int i = 1; i <= steps; ++i) {
            played = player_.moveTo(std::lerp(at_, to, static_cast<double>(i) / steps));
            jump_ = std::max(jump_, std::abs(played.force - force_));
            extrapolated_ += played.extrapolated ? 1 : 0;
            force_ = played.force;
        }
        at_ = to;
        return played;
    }
    void forget() {
        jump_ = 0.0;
        extrapolated_ = 0;
    }

    std::shared_ptr<const PlayedCurve> curve_ = playedCurve(test::adhesiveCycle(), 0.0);
    CurvePlayer player_{*curve_};
    double at_ = curve_->approach.distance.front();
    double force_ = player_.moveTo(at_).force;
    double jump_ = 0.0;
    long extrapolated_ = 0;
};

void expectRecordedBits(const PlayedCurve& curve) {
    CurvePlayer player(curve);
    long others = 0;
    const auto play = [&](const PlayedBranch& branch, std::size_t first) {
        for (std::size_t i = first; i < branch.distance.size(); ++i) {
            const PlayedForce played = player.moveTo(branch.distance[i]);
            const bool isRecorded = played.force == branch.force[i];
            others += isRecorded && !played.extrapolated && !played.beyond ? 0 : 1;
        }
    };
    play(curve.approach, 0);
    play(curve.retract, 1);
    EXPECT_EQ(others, 0);
}

TEST_F(PlayedCycle, TheRecordedBaseGivesTheRecordedBits) {
    ASSERT_GT(curve_->approach.force.size(), 600U);
    expectRecordedBits(*curve_);
}

TEST(PlayedCurves, ThoseOfInstrumentsAreTheRecordedBits) {
    ASPERITY_NEEDS_SHARED_DATA();
    for (const char* name : {"sin_ibw", "spot3_jpk", "refpoints0_jpk", "chiaro_txt"}) {
        SCOPED_TRACE(name);
        const std::string file = "curves/csv/" + std::string(name) + ".csv";
        expectRecordedBits(*playedCurve(readForceCurve(test::sharedData(file)), 1.0));
    }
}

TEST_F(PlayedCycle, BetweenSamplesItIsLinear) {
    const PlayedBranch& branch = curve_->approach;
    std::size_t last = 100;  // whose next sample is nearer to the sample
    while (branch.distance[last + 1] >= branch.distance[last]) {
        ++last;
    }
    for (std::size_t i = 0; i <= last; ++i) {
        (void)player_.moveTo(branch.distance[i]);
    }
    const double between = std::lerp(branch.distance[last], branch.distance[last + 1], 0.25);
    EXPECT_NEAR(player_.moveTo(between).force,
                std::lerp(branch.force[last], branch.force[last + 1], 0.25), 1e-18);
}

TEST_F(PlayedCycle, AboveTheRecordThereIsTheBaseline) {
    const PlayedForce above = player_.moveTo(1e-6);
    EXPECT_EQ(above.force, 0.0);
    EXPECT_FALSE(above.extrapolated);
}

TEST_F(PlayedCycle, BeforeTheTouchItGoesBothWays) {
    EXPECT_NEAR(curve_->touch, test::kCycleSnapIn, 1e-9);
    move(10e-9);
    move(100e-9);
    move(8e-9);
    EXPECT_EQ(extrapolated_, 0);
    EXPECT_FALSE(player_.touches());
    EXPECT_LT(jump_, 60e-12) << "noise";
    EXPECT_LT(std::abs(move(60e-9).force), 60e-12) << "no pull-off of what never touched";
}

TEST_F(PlayedCycle, AnEarlyTurnPlaysTheRetractFromTheSameForce) {
    const PlayedForce turned = move(-5e-9);
    EXPECT_FALSE(turned.extrapolated);
    EXPECT_TRUE(player_.touches());
    forget();
    const PlayedForce up = move(10e-9);
    EXPECT_TRUE(up.extrapolated);
    EXPECT_NEAR(up.force, turned.force - test::kCycleStiffness * 15e-9, 0.1e-9);
    EXPECT_LT(jump_, largestStep(curve_->approach) / 10.0) << "no snap-out";
    const PlayedForce back = move(-4.99e-9);
    EXPECT_NEAR(back.force, turned.force, 0.1e-9) << "nothing is lost";
    EXPECT_TRUE(back.extrapolated);
    EXPECT_LT(jump_, 0.1e-9) << "nor does the force step where it goes on";
    EXPECT_FALSE(move(-15e-9).extrapolated);
    EXPECT_LT(jump_, 0.1e-9);
}

TEST_F(PlayedCycle, ATurnIsSteadyWhereverItIs) {
    const double step = largestStep(curve_->retract);
    for (const double turn : {-1e-9, 3e-9, -19.9e-9, -12e-9, 0.5e-9}) {
        SCOPED_TRACE(turn);
        move(turn);
        for (const double top : {1e-9, 15e-9, 35e-9, 150e-9, 250e-9}) {
            (void)move(turn + 0.2e-9);
            const double before = force_;
            EXPECT_NEAR(player_.moveTo(at_ + 1e-15).force, before, 1e-3 * step);
            (void)move(std::max(top, at_));
            const double above = force_;
            EXPECT_NEAR(player_.moveTo(at_ - 1e-15).force, above, 1e-3 * step);
        }
    }
}

TEST_F(PlayedCycle, AReversalWithinTheRetractGoesBackOnIt) {
    (void)move(curve_->approach.distance.back());
    forget();
    const PlayedForce up = move(15e-9);
    EXPECT_EQ(extrapolated_, 0);
    EXPECT_LT(up.force, -2.5e-9);
    EXPECT_TRUE(move(5e-9).extrapolated);
    EXPECT_NEAR(move(15e-9).force, up.force, 0.1e-9);
    EXPECT_FALSE(move(25e-9).extrapolated) << "recorded again";
}

TEST_F(PlayedCycle, ATipThatCameFreeApproachesAgain) {
    (void)move(curve_->approach.distance.back());
    (void)move(100e-9);
    EXPECT_FALSE(player_.touches());
    forget();
    EXPECT_TRUE(move(99e-9).extrapolated) << "the drag turns";
    EXPECT_LT(jump_, 60e-12);
    EXPECT_LT(std::abs(move(6e-9).force), 60e-12) << "not the retract's pull";
    EXPECT_FALSE(move(0.0).extrapolated);
    EXPECT_TRUE(player_.touches());
}

TEST_F(PlayedCycle, BelowTheRecordThereIsNoForce) {
    const double deepest = curve_->approach.distance.back();
    EXPECT_FALSE(player_.moveTo(deepest).beyond);
    const PlayedForce beyond = player_.moveTo(deepest - 0.01e-9);
    EXPECT_TRUE(beyond.beyond);
    EXPECT_EQ(beyond.force, 0.0);
    EXPECT_FALSE(player_.moveTo(deepest).beyond);
    EXPECT_EQ(player_.moveTo(curve_->retract.distance[5]).force, curve_->retract.force[5]);
}

std::string refusalOf(const MeasuredForceCurve& curve, double stiffness) {
    try {
        (void)playedCurve(curve, stiffness);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(PlayedCurves, NeedALeverAndARetractThatComesFree) {
    MeasuredForceCurve curve = test::adhesiveCycle();
    EXPECT_EQ(playedCurve(curve, 3.0)->stiffness, test::kCycleLever) << "the file's own";
    curve.stiffness = 0.0;
    EXPECT_EQ(playedCurve(curve, 3.0)->stiffness, 3.0);
    EXPECT_THAT(refusalOf(curve, 0.0), HasSubstr("curve_stiffness_n_m"));
    MeasuredForceCurve held = curve;
    held.segments[1].base.resize(90);
    held.segments[1].force.resize(90);
    EXPECT_THAT(refusalOf(held, 3.0), HasSubstr("ends before the tip comes free"));
    held.segments.pop_back();
    EXPECT_THAT(refusalOf(held, 3.0), HasSubstr("no retract"));
}

TEST(PlayedCurves, ADeflectionIsAForceByTheLever) {
    const auto forces = playedCurve(test::adhesiveCycle(), 0.0);
    MeasuredForceCurve curve = test::adhesiveCycle();
    for (CurveSegment& segment : curve.segments) {
        for (const double force : segment.force) {
            segment.deflection.push_back(force / 2.0);
        }
        segment.force.clear();
    }
    curve.stiffness = 0.0;
    EXPECT_THAT(refusalOf(curve, 0.0), HasSubstr("curve_stiffness_n_m"));
    EXPECT_EQ(playedCurve(curve, 2.0)->retract.force, forces->retract.force);
}

}  // namespace
}  // namespace asperity
