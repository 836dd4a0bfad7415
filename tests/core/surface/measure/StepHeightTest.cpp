#include "core/Units.h"
#include "core/surface/measure/Profile.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double kDepth = 23.7_nm;

/// Ridges of 200 nm and grooves of 160 nm with flanks of 20 nm, 5 nm a pixel.
HeightMap uprightGrating() {
    return sampledMap(
        {.columns = 512, .rows = 8, .sizeX = 2560.0_nm, .sizeY = 40.0_nm},
        TrapezoidGrating{
            .pitch = 400.0_nm, .depth = kDepth, .topWidth = 200.0_nm, .flankWidth = 20.0_nm});
}

Profile across(const HeightMap& map, int samples) {
    return profileOf(bilinearField(map).at, Vector2(0.0, 21.0_nm), Vector2(2560.0_nm, 21.0_nm),
                     samples);
}

TEST(StepHeight, BetweenTwoStretchesOfAGratingIsItsDepth) {
    const auto step =
        stepHeight(across(uprightGrating(), 1001), {240.0_nm, 360.0_nm}, {180.0_nm, 20.0_nm});
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->height, kDepth, 1e-12 * kDepth);
    EXPECT_NEAR(step->deviation, 0.0, 1e-12 * kDepth);
}

TEST(StepHeight, OfAWholeGratingIsItsDepth) {
    for (const int samples : {300, 512, 1001, 5000}) {
        const auto step = gratingHeight(across(uprightGrating(), samples));
        ASSERT_TRUE(step) << samples;
        EXPECT_NEAR(step->height, kDepth, 1e-12 * kDepth) << samples;
        EXPECT_NEAR(step->deviation, 0.0, 1e-12 * kDepth) << samples;
        EXPECT_EQ(step->plateaus, 11U) << samples;  // 2560 nm cut a ridge at both ends
    }
}

/// A profile whose heights are exact has an exact step.
TEST(StepHeight, ProfileOfAGratingIsExact) {
    const TrapezoidGrating shape{
        .pitch = 400.0_nm, .depth = kDepth, .topWidth = 200.0_nm, .flankWidth = 20.0_nm};
    const HeightMap map = uprightGrating();
    const Profile profile = profileOf(bilinearField(map).at, Vector2(2.5_nm, 12.5_nm),
                                      Vector2(2557.5_nm, 12.5_nm), 512);
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        EXPECT_NEAR(profile.heights[i], shape.height(profile.distance(i) + 2.5_nm, 0.0),
                    1e-12 * kDepth);
    }
}

TEST(StepHeight, OfAWholeGratingLeavesOutATilt) {
    HeightMap map = uprightGrating();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] += 1.0_um + 0.002 * column * map.pitchX;
        }
    }
    const auto step = gratingHeight(across(map, 512));
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->height, kDepth, 1e-10 * kDepth);
}

TEST(StepHeight, DeviationIsThatOfTheLevels) {
    Profile profile{.from = Vector2::Zero(), .to = Vector2(7.0, 0.0), .heights = {}};
    profile.heights = {1.0, 3.0, 1.0, 3.0, 10.0, 14.0, 10.0, 14.0};
    const auto step = stepHeight(profile, {0.0, 3.0}, {4.0, 7.0});
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->height, 10.0, 1e-14);
    EXPECT_NEAR(step->deviation, std::sqrt(1.0 + 4.0), 1e-14);
    EXPECT_EQ(step->samples, 8U);
}

TEST(StepHeight, IsNoneWithoutTwoLevels) {
    Profile profile{.from = Vector2::Zero(), .to = Vector2(7.0, 0.0), .heights = {}};
    profile.heights = std::vector<double>(8, 2.0);
    EXPECT_FALSE(gratingHeight(profile));
    profile.heights = {0, 0, 0, 0, 5, 5, 5, 5};  // both are cut off by the ends
    EXPECT_FALSE(gratingHeight(profile));
    profile.heights = std::vector<double>(8, std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(gratingHeight(profile));
    EXPECT_FALSE(stepHeight(profile, {0.0, 3.0}, {4.0, 7.0}));
}

TEST(StepHeight, StretchesBesideSamplesWithoutDataAreNoPlateaus) {
    Profile profile{.from = Vector2::Zero(), .to = Vector2(19.0, 0.0), .heights = {}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    profile.heights = {5, 0, 0, 0, 0, 5, 5, 5, 5, 0, 0, nan, 70, 70, 70, 0, 0, 0, 5, 5};
    const auto step = gratingHeight(profile);
    ASSERT_FALSE(step);  // 70 m alone is high, and lies beside the sample without data
    profile.heights = {5, 0, 0, 0, 0, 5, 5, 5, 5, 0, 0, 0, nan, 5, 5, 0, 0, 0, 5, 5};
    EXPECT_EQ(gratingHeight(profile)->plateaus, 3U);
    EXPECT_NEAR(gratingHeight(profile)->height, 5.0, 1e-14);
}

}  // namespace
}  // namespace asperity
