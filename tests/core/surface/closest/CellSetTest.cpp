#include "core/surface/closest/KnownParts.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace asperity {

namespace {

std::vector<std::array<int, 2>> listOf(const CellSet& cells) {
    std::vector<std::array<int, 2>> list;
    cells.forEach([&](const CellIndex& cell) { list.push_back({cell.row, cell.column}); });
    return list;
}

}  // namespace

TEST(CellSet, HoldsWhatWasAdded) {
    CellSet cells({.row = 10, .column = 20});
    cells.add({.row = 10, .column = 20});
    cells.add({.row = 73, .column = 83});
    EXPECT_TRUE(cells.holds({.row = 10, .column = 20}));
    EXPECT_TRUE(cells.holds({.row = 73, .column = 83}));
    EXPECT_FALSE(cells.holds({.row = 10, .column = 21}));
    EXPECT_FALSE(cells.holds({.row = 9, .column = 20}));
    EXPECT_FALSE(cells.holds({.row = 74, .column = 20}));
    EXPECT_FALSE(cells.holds({.row = 10, .column = 84}));
    EXPECT_EQ(listOf(cells), (std::vector<std::array<int, 2>>{{10, 20}, {73, 83}}));
    cells.remove({.row = 10, .column = 20});
    EXPECT_EQ(listOf(cells), (std::vector<std::array<int, 2>>{{73, 83}}));
}

}  // namespace asperity
