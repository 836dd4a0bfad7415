#include "core/Units.h"
#include "core/map/MapPlan.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// Hills that no mirror leaves as they are.
HeightMap lopsidedMap() {
    HeightMap map = test::hillyMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] +=
                2.0_nm * std::sin(0.31 * row) + 1.0_nm * std::cos(0.17 * column);
        }
    }
    return map;
}

HeightMap upsideDown(const HeightMap& map) {
    HeightMap mirrored = map;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            mirrored.heights[map.index(row, column)] =
                map.heights[map.index(map.rows - 1 - row, column)];
        }
    }
    return mirrored;
}

TEST(MapRow, HoldsTheQuantitiesOneAfterTheOther) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const MapInstrument instrument(scene, false);
    const MapPlan all = planMap(scene, {.grid = MapGrid{3, 2}});
    const MapPlan one = planMap(scene, {.grid = MapGrid{3, 2}, .quantities = {"height"}});
    const std::vector<double> values = mapRow(instrument, all, 1);
    const std::vector<double> heights = mapRow(instrument, one, 1);
    ASSERT_EQ(values.size(), 3 * all.quantities.size());
    ASSERT_EQ(heights.size(), 3U);
    const auto index =
        std::ranges::find(all.quantities, MapQuantity::Height) - all.quantities.begin();
    for (std::size_t column = 0; column < 3; ++column) {
        EXPECT_EQ(values[3 * static_cast<std::size_t>(index) + column], heights[column]);
    }
}

TEST(MapRow, OfAFlatScanIsConstant) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const MapPlan plan = planMap(scene, {.grid = MapGrid{7, 5}});
    const MapInstrument instrument(scene, false);
    const std::vector<double> first = mapRow(instrument, plan, 0);
    for (int row = 0; row < plan.grid.rows; ++row) {
        const std::vector<double> values = mapRow(instrument, plan, row);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double expected = first[i - i % 7];
            EXPECT_NEAR(values[i], expected, 1e-9 * std::abs(expected)) << i;
        }
    }
}

/// Across the lever, along which up is like down: mount and friction are the same. The
/// surface is mirrored to the bit; the last digits of a cycle are not, since y from the lower edge
/// and y from the upper edge round differently, and so do the sums of the spline at both.
TEST(MapRow, OfAMirroredScanIsMirrored) {
    const Scene scene = buildScene(test::plainScene(), lopsidedMap());
    const Scene mirrored = buildScene(test::plainScene(), upsideDown(lopsidedMap()));
    for (int row = 0; row < scene.surface.grid().rows; ++row) {
        for (int column = 0; column < scene.surface.grid().columns; ++column) {
            ASSERT_EQ(scene.surface.control(row, column),
                      mirrored.surface.control(scene.surface.grid().rows - 1 - row, column));
        }
    }
    MapPlan plan = planMap(scene, {.grid = MapGrid{16, 16}});
    std::erase(plan.quantities, MapQuantity::Iterations);
    for (int row = 0; row < plan.grid.rows; ++row) {
        const std::vector<double> one = mapRow(MapInstrument(scene, false), plan, row);
        const std::vector<double> other =
            mapRow(MapInstrument(mirrored, false), plan, plan.grid.rows - 1 - row);
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_NEAR(one[i], other[i], 1e-9 * std::abs(one[i])) << row << ", " << i;
        }
    }
}

}  // namespace
}  // namespace asperity
