#include "core/surface/leveling/Leveling.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using test::kNan;

/// Whole periods, with unequal periods and pixels that are not square.
HeightMap eggBoxHills() {
    return sampledMap({.columns = 48, .rows = 32, .sizeX = 480.0_nm, .sizeY = 480.0_nm},
                      EggBox{.amplitude = 4.0_nm, .periodX = 240.0_nm, .periodY = 120.0_nm});
}

HeightMap withPlane(HeightMap map, double offset, double slopeX, double slopeY) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] += offset + slopeX * (column + 0.5) * map.pitchX +
                                                   slopeY * (map.rows - row - 0.5) * map.pitchY;
        }
    }
    return map;
}

TEST(Leveling, FindsThePlaneWithYUp) {
    const HeightMap flat = flatMap({.columns = 9, .rows = 7, .sizeX = 90.0_nm, .sizeY = 140.0_nm});
    const PlaneFit plane = fitPlane(withPlane(flat, 3.0_nm, 0.02, -0.05));
    EXPECT_NEAR(plane.slopeX, 0.02, 1e-14);
    EXPECT_NEAR(plane.slopeY, -0.05, 1e-14);
    EXPECT_NEAR(plane.at(0.0, 0.0), 3.0_nm, 1e-21);
    EXPECT_NEAR(plane.at(90.0_nm, 140.0_nm), 3.0_nm + 1.8_nm - 7.0_nm, 1e-21);
}

TEST(Leveling, GivesBackASurfaceWhateverPlaneWasAdded) {
    const HeightMap leveledHills = leveled(eggBoxHills(), {LevelingStep::Plane});
    const HeightMap tilted =
        leveled(withPlane(eggBoxHills(), 2.0_um, 0.3, -0.7), {LevelingStep::Plane});
    for (std::size_t i = 0; i < tilted.heights.size(); ++i) {
        // relative to what was removed
        ASSERT_NEAR(tilted.heights[i], leveledHills.heights[i], 1e-12 * 2.0_um);
    }
}

TEST(Leveling, LeavesNoMeanAndNoTilt) {
    const PlaneFit rest =
        fitPlane(leveled(withPlane(eggBoxHills(), 5.0_nm, 0.1, 0.2), {LevelingStep::Plane}));
    EXPECT_NEAR(rest.slopeX, 0.0, 1e-15);
    EXPECT_NEAR(rest.slopeY, 0.0, 1e-15);
    EXPECT_NEAR(rest.mean, 0.0, 1e-22);
}

TEST(Leveling, IgnoresInvalidPixelsAndLeavesThemAlone) {
    HeightMap map = withPlane(
        flatMap({.columns = 8, .rows = 8, .sizeX = 80.0_nm, .sizeY = 80.0_nm}), 0.0, 0.1, 0.0);
    map.heights[map.index(2, 3)] = kNan;
    map.invalid.assign(map.heights.size(), 0);
    map.heights[map.index(5, 1)] = 1.0;  // a meter: masked by the user
    map.invalid[map.index(5, 1)] = 1;
    const HeightMap level = leveled(map, {LevelingStep::Plane});
    EXPECT_NEAR(fitPlane(map).slopeX, 0.1, 1e-14);
    EXPECT_TRUE(std::isnan(level.at(2, 3)));
    EXPECT_NEAR(level.at(0, 0), 0.0, 1e-22);
}

TEST(Leveling, TakesASingleLineOfPixelsAsLevelAcrossIt) {
    const HeightMap row = withPlane(
        flatMap({.columns = 5, .rows = 1, .sizeX = 50.0_nm, .sizeY = 10.0_nm}), 0.0, 0.1, 0.0);
    EXPECT_NEAR(fitPlane(row).slopeX, 0.1, 1e-14);
    EXPECT_EQ(fitPlane(row).slopeY, 0.0);
    const HeightMap pixel = flatMap({.columns = 1, .rows = 1, .sizeX = 1.0_nm, .sizeY = 1.0_nm});
    EXPECT_EQ(fitPlane(pixel).slopeX, 0.0);
    EXPECT_EQ(fitPlane(pixel).slopeY, 0.0);
}

TEST(Leveling, RowsRemovesRowOffsetsExactlyWhereMostOfEachRowIsFlat) {
    HeightMap map = flatMap({.columns = 9, .rows = 4, .sizeX = 9.0_nm, .sizeY = 4.0_nm});
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 9; ++column) {
            const double island = column < 3 ? 2.0 : 0.0;
            map.heights[map.index(row, column)] = island + 16.0 * row;
        }
    }
    const HeightMap level = leveled(map, {LevelingStep::Rows});
    for (int row = 0; row < 4; ++row) {
        EXPECT_EQ(level.at(row, 0) - level.at(row, 8), 2.0);
        EXPECT_EQ(level.at(row, 8), level.at(0, 8));
    }
    EXPECT_NEAR(fitPlane(level).mean, 0.0, 1e-15);
}

TEST(Leveling, MedianOfAnEvenRowIsTheMeanOfTheTwoMiddleValues) {
    HeightMap map = flatMap({.columns = 4, .rows = 1, .sizeX = 4.0, .sizeY = 1.0});
    map.heights = {8.0, 1.0, 4.0, 2.0};  // median 3, and then mean 0.75
    const HeightMap level = leveled(map, {LevelingStep::Rows});
    EXPECT_EQ(level.heights, (std::vector<double>{4.25, -2.75, 0.25, -1.75}));
}

TEST(Leveling, LeavesNoRoughnessOfAPlaneButThatOfSmallHills) {
    const HeightMap flat = flatMap({.columns = 9, .rows = 7, .sizeX = 90.0_nm, .sizeY = 140.0_nm});
    const HeightMap level = leveled(withPlane(flat, 3.0_nm, 0.02, -0.05), {LevelingStep::Plane});
    EXPECT_TRUE(std::ranges::all_of(level.heights, [](double height) { return height == 0.0; }));
    HeightMap hills = eggBoxHills();
    for (double& height : hills.heights) {
        height *= 1e-9;
    }
    const HeightMap small = leveled(withPlane(hills, 2.0_um, 0.3, -0.7), {LevelingStep::Plane});
    EXPECT_GT(*std::ranges::max_element(small.heights), 3e-9 * 1.0_nm);
}

TEST(Leveling, NoneChangesNothing) {
    const HeightMap map = eggBoxHills();
    EXPECT_EQ(leveled(map, {}).heights, map.heights);
}

TEST(Leveling, RefusesAMapWithoutAValidPixel) {
    HeightMap map = flatMap({.columns = 3, .rows = 2, .sizeX = 3.0_nm, .sizeY = 2.0_nm});
    map.heights.assign(6, kNan);
    EXPECT_THROW((void)fitPlane(map), Error);
    EXPECT_THROW((void)leveled(map, {LevelingStep::Rows}), Error);
    EXPECT_THROW((void)fitPlane(HeightMap{}), Error);
}

TEST(Leveling, DoesStepsInOrderAndSaysWhatEachRemoved) {
    const HeightMap tilted = withPlane(eggBoxHills(), 2.0_um, 0.3, -0.7);
    const LeveledMap<HeightMap> level =
        leveledInSteps(tilted, {LevelingStep::Plane, LevelingStep::Zero});
    ASSERT_EQ(level.removed.size(), 2U);
    EXPECT_EQ(level.removed[0].step, LevelingStep::Plane);
    EXPECT_NEAR(level.removed[0].plane.slopeX, 0.3, 1e-12);
    EXPECT_NEAR(level.removed[1].plane.mean, -4.0_nm, 0.5_nm);
    EXPECT_EQ(*std::ranges::min_element(level.map.heights), 0.0);
    const HeightMap other = leveled(tilted, {LevelingStep::Zero, LevelingStep::Plane});
    EXPECT_NEAR(fitPlane(other).mean, 0.0, 1e-20);
}

TEST(Leveling, ZeroSetsTheLowestValidHeightToZero) {
    HeightMap map = flatMap({.columns = 3, .rows = 1, .sizeX = 3.0, .sizeY = 1.0});
    map.heights = {-2.0, 5.0, -9.0};
    map.invalid = {false, false, true};
    const HeightMap level = leveled(map, {LevelingStep::Zero});
    EXPECT_EQ(level.heights, (std::vector<double>{0.0, 7.0, -7.0}));
}

TEST(Leveling, PlanesOfSeveralStepsAddUp) {
    const HeightMap tilted = withPlane(eggBoxHills(), 20.0_nm, 0.03, -0.07);
    const LevelPoints points{Vector2(100.0_nm, 100.0_nm), Vector2(400.0_nm, 150.0_nm),
                             Vector2(250.0_nm, 390.0_nm)};
    const LeveledMap<HeightMap> level = leveledInSteps(
        tilted, {LevelingStep::ThreePoint, LevelingStep::Plane, LevelingStep::Zero}, points);
    const PlaneFit sum = sumOfPlanes(level.removed);
    for (const auto& [row, column] : {std::pair{0, 0}, {31, 47}, {4, 40}}) {
        EXPECT_NEAR(sum.at((column + 0.5) * tilted.pitchX, (31.5 - row) * tilted.pitchY),
                    tilted.at(row, column) - level.map.at(row, column), 1e-22 + 1e-14 * 20.0_nm);
    }
    EXPECT_EQ(sumOfPlanes({}), PlaneFit{});
}

/// Told with what a map in single precision is relative to.
TEST(Leveling, WhatIsRemovedFromAScanMapHoldsItsDatum) {
    const ScanMap scan = test::singlePrecision(withPlane(eggBoxHills(), 2.0_um, 0.0, 0.0));
    const auto zeroed = leveledInSteps(scan, {LevelingStep::Zero});
    EXPECT_NEAR(zeroed.removed.front().plane.mean, 2.0_um - 4.0_nm, 0.5_nm);
    const auto shifted =
        leveledInSteps(scan, {LevelingStep::MedianOfDifferences, LevelingStep::Plane});
    EXPECT_NEAR(shifted.removed.back().plane.mean, 2.0_um, 1e-6_nm);
    EXPECT_EQ(shifted.map.datum, 0.0);
}

TEST(Leveling, ReportsProgressAndCanBeCanceled) {
    test::CanceledAfter whole(1000000);
    (void)leveled(eggBoxHills(), {LevelingStep::Plane, LevelingStep::Facet, LevelingStep::Zero}, {},
                  &whole);
    test::CanceledAfter early(2);
    EXPECT_THROW(
        (void)leveled(eggBoxHills(), {LevelingStep::Plane, LevelingStep::Facet}, {}, &early),
        Canceled);
}

/// Canceled as soon as a step is on its way.
class CanceledWithin : public Progress {
public:
    void report(double fraction) override {
        isWithin_ = isWithin_ || (fraction > 0.0 && fraction < 1.0);
    }
    [[nodiscard]] bool isCanceled() const override { return isWithin_; }

private:
    bool isWithin_ = false;
};

/// Not only between steps: one may take seconds on a large scan.
TEST(Leveling, EachStepReportsWithinAndCanBeCanceledThere) {
    const HeightMap map =
        flatMap({.columns = 40, .rows = 400, .sizeX = 40.0_nm, .sizeY = 400.0_nm});
    const HeightMap steps = withPlane(map, 0.0, 0.02, 0.5);
    const LevelPoints points{Vector2(1.0_nm, 1.0_nm), Vector2(30.0_nm, 2.0_nm),
                             Vector2(2.0_nm, 300.0_nm)};
    for (const auto& step : kEnumTable<LevelingStep>) {
        CanceledWithin progress;
        EXPECT_THROW((void)leveled(steps, {step.value}, points, &progress), Canceled) << step.name;
    }
}

}  // namespace
}  // namespace asperity
