#include "core/surface/closest/PartFacts.h"
#include "tests/core/surface/closest/RoughParts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {

namespace {

class PartBatchOf : public test::PartsOf {};

TEST_P(PartBatchOf, HoldsTheHeightsAtTheCornersOfItsParts) {
    const double rounding = 1e-14 * (surface_.heightScale() + 5.0_nm);
    for (int i = 0; i < 200; ++i) {
        const PartBatch batch = randomBatch(i % 5);
        for (int lane = 0; lane < PartBatch::kLanes; ++lane) {
            const double x = batch.centerX[lane];
            const double y = batch.centerY[lane];
            const double halfX = batch.halfX[lane];
            const double halfY = batch.halfY[lane];
            EXPECT_NEAR(batch.net[0][0][lane], aboveDatum(x - halfX, y - halfY), rounding);
            EXPECT_NEAR(batch.net[0][3][lane], aboveDatum(x + halfX, y - halfY), rounding);
            EXPECT_NEAR(batch.net[3][0][lane], aboveDatum(x - halfX, y + halfY), rounding);
            EXPECT_NEAR(batch.net[3][3][lane], aboveDatum(x + halfX, y + halfY), rounding);
        }
    }
}

/// Parts of cells are what quartering the cells leads to.
TEST_P(PartBatchOf, LoadsPartsOfCells) {
    const double rounding = 1e-14 * (surface_.heightScale() + 5.0_nm);
    const CellBounds::Level& cells = surface_.bounds().level(0);
    const auto below = [&](int count) { return static_cast<int>(random_.uniform() * count); };
    for (int i = 0; i < 200; ++i) {
        CellPart part{.cell = {.row = below(cells.rows), .column = below(cells.columns)}};
        PartBatch quarters;
        loadCells(surface_.grid(), {&part.cell, 1}, quarters);
        int lane = 0;
        for (int k = 0; k < i % (CellPart::kMaxDepth + 1); ++k) {
            const PartBatch whole = quarters;
            quarter(whole, lane, quarters);
            lane = below(PartBatch::kLanes);
            part = part.quarter(lane);
        }
        PartBatch batch;
        loadParts(surface_.grid(), {&part, 1}, batch);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                ASSERT_NEAR(batch.net[row][column][0], quarters.net[row][column][lane], rounding);
            }
        }
        const double position = 1e-12 * (surface_.sizeX() + surface_.sizeY());
        ASSERT_NEAR(batch.centerX[0], quarters.centerX[lane], position);
        ASSERT_NEAR(batch.centerY[0], quarters.centerY[lane], position);
        ASSERT_NEAR(batch.halfX[0], quarters.halfX[lane], position);
        ASSERT_NEAR(batch.halfY[0], quarters.halfY[lane], position);
    }
}

TEST_P(PartBatchOf, KnowsWhichPositionsItsPartsHold) {
    const BSplineSurface::Grid& grid = surface_.grid();
    const CellBounds::Level& cells = surface_.bounds().level(0);
    const auto below = [&](int count) { return static_cast<int>(random_.uniform() * count); };
    for (int i = 0; i < 400; ++i) {
        CellPart part{.cell = {.row = below(cells.rows), .column = below(cells.columns)}};
        for (int k = 0; k < i % 5; ++k) {
            part = part.quarter(static_cast<int>(random_.uniform() * PartBatch::kLanes));
        }
        PartBatch batch;
        loadParts(grid, {&part, 1}, batch);
        const double shareX = random_.uniform(-2.0, 2.0);
        const double shareY = random_.uniform(-2.0, 2.0);
        const Vector2 position(batch.centerX[0] + shareX * batch.halfX[0],
                               batch.centerY[0] + shareY * batch.halfY[0]);
        ASSERT_EQ(part.contains(grid, position), std::abs(shareX) < 1.0 && std::abs(shareY) < 1.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, PartBatchOf, testing::ValuesIn(test::mapsOfParts()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
