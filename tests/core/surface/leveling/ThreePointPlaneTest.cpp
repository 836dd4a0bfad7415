#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/leveling/PlaneFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;

/// A slope of 0.02 and -0.05 with a wide step over half of the scan.
HeightMap terrace() {
    HeightMap map = flatMap({.columns = 40, .rows = 30, .sizeX = 400.0_nm, .sizeY = 600.0_nm});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = 5.0_nm + 0.02 * (column + 0.5) * map.pitchX -
                                                  0.05 * (map.rows - row - 0.5) * map.pitchY +
                                                  (column >= 25 ? 30.0_nm : 0.0);
        }
    }
    return map;
}

/// On the lower terrace; one at the very corner, where the neighborhood is cut.
LevelPoints lowPoints() {
    return {Vector2(0.0, 0.0), Vector2(213.0_nm, 41.0_nm), Vector2(87.0_nm, 577.0_nm)};
}

TEST(ThreePointPlane, IsThatOfTheTerraceThatThePositionsAreOn) {
    const PlaneFit plane = threePointPlane(terrace(), lowPoints());
    EXPECT_NEAR(plane.slopeX, 0.02, 1e-14);
    EXPECT_NEAR(plane.slopeY, -0.05, 1e-14);
    EXPECT_NEAR(plane.at(0.0, 0.0), 5.0_nm, 1e-21);
    const HeightMap level = leveled(terrace(), {LevelingStep::ThreePoint}, lowPoints());
    EXPECT_NEAR(level.at(29, 0), 0.0, 1e-21);
    EXPECT_NEAR(level.at(4, 30), 30.0_nm, 1e-21);
}

TEST(ThreePointPlane, TakesTheMeanOfTheValidPixelsAround) {
    HeightMap map = flatMap({.columns = 9, .rows = 9, .sizeX = 9.0, .sizeY = 9.0});
    map.heights[map.index(4, 4)] = 9.0;
    map.heights[map.index(4, 5)] = std::numeric_limits<double>::quiet_NaN();
    const LevelPoints points{Vector2(4.5, 4.5), Vector2(1.5, 1.5), Vector2(7.5, 1.5)};
    // 9 m in one of eight pixels, whose mean position is an eighth of a pixel to the left.
    EXPECT_NEAR(threePointPlane(map, points).at(4.375, 4.5), 9.0 / 8.0, 1e-14);
}

TEST(ThreePointPlane, RefusesPositionsThatFixNoPlane) {
    const auto refusalFor = [](const std::optional<LevelPoints>& points,
                               const HeightMap& map) -> std::string {
        try {
            (void)leveled(map, {LevelingStep::ThreePoint}, points);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusalFor(std::nullopt, terrace()), HasSubstr("needs three points"));
    EXPECT_THAT(refusalFor(LevelPoints{Vector2(0.0, 0.0), Vector2(100.0_nm, 100.0_nm),
                                       Vector2(200.0_nm, 200.0_nm)},
                           terrace()),
                HasSubstr("do not lie on one line"));
    EXPECT_THAT(refusalFor(LevelPoints{Vector2(55.0_nm, 50.0_nm), Vector2(155.0_nm, 50.0_nm),
                                       Vector2(105.0_nm, 51.0_nm)},
                           terrace()),
                HasSubstr("on one line within a pixel"));
    LevelPoints outside = lowPoints();
    outside[2] = Vector2(-1.0_nm, 20.0_nm);
    EXPECT_THAT(refusalFor(outside, terrace()), HasSubstr("outside the scan"));
    HeightMap holey = terrace();
    holey.invalid.assign(holey.heights.size(), false);
    for (int row = 0; row < 5; ++row) {
        for (int column = 5; column < 12; ++column) {
            holey.invalid[holey.index(row, column)] = true;
        }
    }
    EXPECT_THAT(refusalFor(lowPoints(), holey), HasSubstr("holds data"));
}

}  // namespace
}  // namespace asperity
