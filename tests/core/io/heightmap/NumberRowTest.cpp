#include "core/io/heightmap/NumberRow.h"

#include "tests/support/DoubleLimits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;

NumberRow rowOf(std::string_view line) {
    NumberRow row;
    readNumberRow(line, numberStyleOf(line), row);
    EXPECT_EQ(row.wrong, "") << line;
    return row;
}

}  // namespace

TEST(NumberRow, BlanksAndTabsSeparate) {
    EXPECT_THAT(rowOf(" 1.5\t-2e-008   +3 ").numbers, ElementsAre(1.5, -2e-8, 3.0));
    EXPECT_THAT(rowOf(".5 5. 1E+003").numbers, ElementsAre(0.5, 5.0, 1000.0));
}

TEST(NumberRow, SemicolonsLeaveTheCommaToTheDecimals) {
    EXPECT_THAT(rowOf("1,5;2;-3,25e-2").numbers, ElementsAre(1.5, 2.0, -0.0325));
    EXPECT_THAT(rowOf("1.5; 2 ;3").numbers, ElementsAre(1.5, 2.0, 3.0));
}

TEST(NumberRow, CommasSeparateWhereNothingElseDoes) {
    EXPECT_THAT(rowOf("1,5,-2.5").numbers, ElementsAre(1.0, 5.0, -2.5));
    EXPECT_THAT(rowOf("1, 5, 2").numbers, ElementsAre(1.0, 5.0, 2.0));
    EXPECT_THAT(rowOf("1,5 2,5\t3").numbers, ElementsAre(1.5, 2.5, 3.0));
}

TEST(NumberRow, WordsForNoDataAreNaN) {
    for (const char* word : {"NaN", "nan", "BAD", "Bad", "***", "----", "1.#QNAN", "-1.#IND", "--",
                             "N/A", "-nan(ind)"}) {
        EXPECT_THAT(rowOf("1 " + std::string(word) + " 3").numbers,
                    ElementsAre(1.0, NanSensitiveDoubleEq(kNan), 3.0))
            << word;
    }
}

TEST(NumberRow, EmptyCellsHoldNoDataAndTheLastOneIsTold) {
    const NumberRow row = rowOf("1;;3;");
    EXPECT_THAT(row.numbers,
                ElementsAre(1.0, NanSensitiveDoubleEq(kNan), 3.0, NanSensitiveDoubleEq(kNan)));
    EXPECT_TRUE(row.endsEmpty);
    EXPECT_FALSE(rowOf("1;2").endsEmpty);
}

/// As a spreadsheet exports them: the values behind would move into wrong columns.
TEST(NumberRow, EmptyCellsBetweenTabsHoldNoData) {
    EXPECT_THAT(rowOf("1\t\t3,5").numbers, ElementsAre(1.0, NanSensitiveDoubleEq(kNan), 3.5));
    NumberRow row;
    readNumberRow("\t2\t3", numberStyleOf("1\t2\t3"), row);
    EXPECT_THAT(row.numbers, ElementsAre(NanSensitiveDoubleEq(kNan), 2.0, 3.0));
}

TEST(NumberRow, NumbersBelowTheSmallestAreZero) {
    EXPECT_THAT(rowOf("1e-400 -1e-400\t2").numbers, ElementsAre(0.0, 0.0, 2.0));
}

TEST(NumberRow, WhatIsNoNumberIsGivenBack) {
    for (const char* cell : {"x", "1.2.3", "1,2,3", "0x10", "1e999", "12abc", "\xB5", "-"}) {
        NumberRow row;
        const std::string line = "1 " + std::string(cell) + " 3";
        readNumberRow(line, {.separator = ' ', .decimalComma = true}, row);
        EXPECT_EQ(row.wrong, cell);
    }
}

}  // namespace asperity::test
