#include "core/haptics/cycle/CurveBranch.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>

namespace asperity {
namespace {

/// The branch at each height [nm], one letter a tick.
std::string branches(std::initializer_list<double> heights,
                     PositionControl control = PositionControl::Base) {
    BranchTracker tracker;
    std::string found;
    for (const double height : heights) {
        TickInput input;
        input.settings.positionControl = control;
        TickOutput out;
        (control == PositionControl::Tip ? out.model.tip : out.base.position).z() = height * 1e-9;
        found += tracker.take(input, out) == CurveBranch::Approach ? 'a' : 'r';
    }
    return found;
}

TEST(CurveBranch, IsTheWayThatTheBaseWentLast) {
    EXPECT_EQ(branches({9.0, 5.0, 1.0, 2.0, 6.0, 4.0}), "aaarra");
}

TEST(CurveBranch, ARunThatBeginsUpwardsSoonRetracts) {
    EXPECT_EQ(branches({1.0, 1.02, 1.2}), "aar");
}

TEST(CurveBranch, ATipAtRestStaysOnItsBranch) {
    EXPECT_EQ(branches({9.0, 1.0, 1.0, 1.0}), "aaaa");
    EXPECT_EQ(branches({1.0, 9.0, 9.0, 9.0}), "arrr");
}

TEST(CurveBranch, JitterOfADeviceTurnsNothing) {
    EXPECT_EQ(branches({5.0, 4.0, 4.03, 3.99, 4.03, 3.99}), "aaaaaa");
    EXPECT_EQ(branches({4.0, 5.0, 4.97, 5.01, 4.97}), "arrrr");
}

TEST(CurveBranch, SmallStepsBackAddUp) {
    EXPECT_EQ(branches({5.0, 4.0, 4.02, 4.04, 4.06}), "aaaar");
}

TEST(CurveBranch, UnderTipControlItIsTheWayOfTheTip) {
    EXPECT_EQ(branches({9.0, 5.0, 6.0}, PositionControl::Tip), "aar");
}

TEST(CurveBranch, AHeightThatIsNoNumberChangesNothing) {
    EXPECT_EQ(branches({5.0, 6.0, std::numeric_limits<double>::quiet_NaN(), 6.0}), "arrr");
}

}  // namespace
}  // namespace asperity
