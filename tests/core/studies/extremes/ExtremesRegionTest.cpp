#include "core/studies/extremes/ExtremesRegion.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Verdict, FollowsTheError) {
    EXPECT_EQ(verdictOnError(0.0), Verdict::Exact);
    EXPECT_EQ(verdictOnError(0.01), Verdict::Valid);
    EXPECT_EQ(verdictOnError(0.06), Verdict::Off);
}

TEST(Verdict, ErrorIsRelativeToTheLargestOfBothAndTheUnit) {
    EXPECT_EQ(relativeError(0.0, 0.0, 0.0), 0.0);
    EXPECT_EQ(relativeError(1.0, 0.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(relativeError(1.0, 3.0, 10.0), 0.2);
}

TEST(ExtremesRegion, KeepsTheWorstOfEachVerdictAndWhere) {
    ExtremesRegion region({.model = "md"});
    region.add({.errors = {.force = 1e-5}}, [] { return std::string("a"); });
    region.add({.errors = {.force = 0.02, .contactRadius = 0.01}}, [] { return std::string("b"); });
    ValidityFlags large;
    large.set(Validity::LargeContact, true);
    region.add({.flags = large, .errors = {.force = 0.9}}, [] { return std::string("c"); });
    region.refuse("no", 2);
    EXPECT_EQ(region.states(), 5);
    EXPECT_EQ(region.tally(Verdict::Exact).force.where, "a");
    EXPECT_EQ(region.unflagged().force.error, 0.02);
    EXPECT_EQ(region.unflagged().contactRadius.where, "b");
    EXPECT_EQ(region.tally(Verdict::Flagged).force.where, "c");
    EXPECT_EQ(region.mainReason(), "no");
}

TEST(ExtremesRegion, AStateWithoutAReferenceIsUnprovenAndHasNoErrors) {
    ExtremesRegion region({.model = "split"});
    region.add({.referenceHolds = false, .errors = {.force = 0.5}}, [] { return std::string(); });
    EXPECT_EQ(region.tally(Verdict::Unproven).states, 1);
    EXPECT_EQ(region.tally(Verdict::Unproven).force.error, 0.0);
    EXPECT_EQ(region.mainReason(), "reference not proven");
    ValidityFlags large;
    large.set(Validity::LargeContact, true);
    region.add({.flags = large, .referenceHolds = false}, [] { return std::string(); });
    EXPECT_EQ(region.tally(Verdict::Flagged).states, 1) << "what is flagged says so itself";
}

TEST(ExtremesRegion, IsSummedOverPositions) {
    const auto one = [](const char* setting, double radius) {
        ExtremesRegion region({.model = "md", .setting = setting, .tipRadius = radius});
        region.add({.errors = {.force = radius}}, [] { return std::string(); });
        return region;
    };
    const auto sums = summedBySample({one("a", 1e-6), one("a", 2e-6), one("b", 1e-6)});
    ASSERT_EQ(sums.size(), 2U);
    EXPECT_EQ(sums[0].states(), 2);
    EXPECT_EQ(sums[0].unflagged().force.error, 2e-6);
}

}  // namespace
}  // namespace asperity
