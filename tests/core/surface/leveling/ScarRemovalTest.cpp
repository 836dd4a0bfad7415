#include "core/surface/leveling/ScarRemoval.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/leveling/Leveling.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace asperity {
namespace {

/// Gentle hills, straight along y, so that interpolation between rows is exact.
HeightMap gentleHills() {
    HeightMap map = flatMap({.columns = 64, .rows = 40, .sizeX = 640.0_nm, .sizeY = 400.0_nm});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] =
                4.0_nm * std::sin(0.3 * column) + 0.05_nm * (row - 20) * std::cos(0.2 * column);
        }
    }
    return map;
}

/// Rows `top` to `top + width - 1`, columns `left` to `left + length - 1`.
struct Scar {
    int top = 0;
    int width = 1;
    int left = 0;
    int length = 16;
    double height = 0.0;  ///< [m]
};

HeightMap scarred(HeightMap map, const Scar& scar) {
    for (int row = scar.top; row < scar.top + scar.width; ++row) {
        for (int column = scar.left; column < scar.left + scar.length; ++column) {
            map.heights[map.index(row, column)] += scar.height;
        }
    }
    return map;
}

std::ptrdiff_t scarsIn(const HeightMap& map) { return std::ranges::count(scarsOf(map), true); }

TEST(ScarRemoval, MarksAndInterpolatesScarsOfBothSigns) {
    HeightMap map =
        scarred(gentleHills(), {.top = 7, .width = 1, .left = 5, .length = 30, .height = 9.0_nm});
    map = scarred(map, {.top = 20, .width = 4, .left = 40, .length = 20, .height = -8.0_nm});
    const LeveledMap<HeightMap> level = leveledInSteps(map, {LevelingStep::Scars});
    EXPECT_EQ(level.removed.front().pixels, 30U + 80U);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const bool isScar = (row == 7 && column >= 5 && column < 35) ||
                                (row >= 20 && row < 24 && column >= 40 && column < 60);
            ASSERT_EQ(level.map.isValid(row, column), !isScar) << row << ' ' << column;
            ASSERT_NEAR(level.map.at(row, column), gentleHills().at(row, column), 1e-21);
        }
    }
}

TEST(ScarRemoval, LeavesWhatIsTooShortTooWideOrTooFaint) {
    EXPECT_EQ(scarsIn(gentleHills()), 0);
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 7, .left = 5, .length = 15, .height = 9.0_nm})), 0);
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 7, .left = 5, .length = 16, .height = 9.0_nm})), 16);
    EXPECT_EQ(scarsIn(scarred(gentleHills(),
                              {.top = 7, .width = 5, .left = 5, .length = 30, .height = 9.0_nm})),
              0);
    // Beside a large one, which sets the root mean square, 0.6 of it is not enough.
    const HeightMap large =
        scarred(gentleHills(), {.top = 30, .left = 0, .length = 60, .height = 90.0_nm});
    const double rms = 90.0_nm * std::sqrt(2.0 * 60.0 / (64.0 * 40.0));
    EXPECT_EQ(scarsIn(scarred(large, {.top = 7, .left = 5, .length = 30, .height = 0.6 * rms})),
              60);
    EXPECT_EQ(scarsIn(scarred(large, {.top = 7, .left = 5, .length = 30, .height = 0.7 * rms})),
              90);
}

/// Beyond the hard threshold at one pixel, the soft one elsewhere.
TEST(ScarRemoval, SpreadsOverWhatStandsOutByTheSoftThreshold) {
    const HeightMap large =
        scarred(gentleHills(), {.top = 30, .left = 0, .length = 60, .height = 90.0_nm});
    const double rms = 90.0_nm * std::sqrt(2.0 * 60.0 / (64.0 * 40.0));
    HeightMap map = scarred(large, {.top = 7, .left = 5, .length = 30, .height = 0.4 * rms});
    EXPECT_EQ(scarsIn(map), 60);
    map.heights[map.index(7, 20)] += 0.5 * rms;
    EXPECT_EQ(scarsIn(map), 90);
}

TEST(ScarRemoval, FindsScarsBesideTheLastRowButNotOnTheEdges) {
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 38, .left = 5, .length = 20, .height = 9.0_nm})),
        20);
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 1, .left = 44, .length = 20, .height = 9.0_nm})),
        20);
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 0, .left = 5, .length = 20, .height = 9.0_nm})), 0);
    EXPECT_EQ(
        scarsIn(scarred(gentleHills(), {.top = 39, .left = 5, .length = 20, .height = 9.0_nm})), 0);
}

TEST(ScarRemoval, TakesNoPixelWithoutDataForAScarOrAnEdge) {
    HeightMap map = scarred(gentleHills(), {.top = 7, .left = 5, .length = 40, .height = 9.0_nm});
    map.heights[map.index(6, 10)] = std::numeric_limits<double>::quiet_NaN();
    map.invalid.assign(map.heights.size(), false);
    map.invalid[map.index(7, 30)] = true;
    const LeveledMap<HeightMap> level = leveledInSteps(map, {LevelingStep::Scars});
    // Columns 5 to 9 are too short now; 11 to 29 remain; 31 to 44 are too short.
    EXPECT_EQ(level.removed.front().pixels, 19U);
    EXPECT_EQ(level.map.at(7, 30), map.at(7, 30));
    EXPECT_TRUE(level.map.isValid(7, 31));
}

TEST(ScarRemoval, OfSinglePrecisionFindsTheSamePixels) {
    const HeightMap map = scarred(
        gentleHills(), {.top = 20, .width = 4, .left = 40, .length = 20, .height = -8.0_nm});
    EXPECT_EQ(scarsOf(test::singlePrecision(map)), scarsOf(map));
}

TEST(ScarRemoval, OfFewRowsFindsNone) {
    EXPECT_EQ(scarsIn(flatMap({.columns = 20, .rows = 2, .sizeX = 1.0, .sizeY = 1.0})), 0);
    EXPECT_EQ(scarsIn(flatMap({.columns = 20, .rows = 20, .sizeX = 1.0, .sizeY = 1.0})), 0);
    EXPECT_THROW((void)scarsOf(HeightMap{}), Error);
}

/// What comes after moves the filled heights along with their neighbors, and does not count them.
TEST(ScarRemoval, FilledPixelsTakeNoPartInLaterSteps) {
    HeightMap map = scarred(gentleHills(), {.top = 7, .left = 5, .length = 30, .height = 9.0_nm});
    const HeightMap level = leveled(map, {LevelingStep::Scars, LevelingStep::Plane});
    EXPECT_NEAR(level.at(7, 20), 0.5 * (level.at(6, 20) + level.at(8, 20)), 1e-21);
    map.invalid.assign(map.heights.size(), false);
    std::fill_n(map.invalid.begin() + static_cast<std::ptrdiff_t>(map.index(7, 5)), 30, true);
    EXPECT_EQ(level.at(0, 0), leveled(map, {LevelingStep::Plane}).at(0, 0));
}

}  // namespace
}  // namespace asperity
