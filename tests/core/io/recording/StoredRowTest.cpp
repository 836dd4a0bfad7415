#include "core/io/recording/StoredRow.h"

#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

using test::kInfinity;
using test::kNan;

bool isTaken(Holds holds, double number) {
    return stored::objection<double>(holds, number) == nullptr;
}

TEST(StoredRow, EachKindOfColumnTakesWhatItSays) {
    struct Case {
        Holds holds;
        bool negative, zero, one, two, infinity, nan;
    };
    for (const Case& kind : {Case{Holds::Stored, true, true, true, true, false, false},
                             Case{Holds::Endless, true, true, true, true, true, false},
                             Case{Holds::Finite, true, true, true, true, false, false},
                             Case{Holds::Positive, false, false, true, true, false, false},
                             Case{Holds::NotNegative, false, true, true, true, false, false},
                             Case{Holds::Share, false, true, true, false, false, false},
                             Case{Holds::Told, true, true, true, true, true, true}}) {
        SCOPED_TRACE(static_cast<int>(kind.holds));
        EXPECT_EQ(isTaken(kind.holds, -1.0), kind.negative);
        EXPECT_EQ(isTaken(kind.holds, 0.0), kind.zero);
        EXPECT_EQ(isTaken(kind.holds, 1.0), kind.one);
        EXPECT_EQ(isTaken(kind.holds, 2.0), kind.two);
        EXPECT_EQ(isTaken(kind.holds, kInfinity), kind.infinity);
        EXPECT_EQ(isTaken(kind.holds, kNan), kind.nan);
    }
}

TEST(StoredRow, KeepsWhatALaterColumnDoesNotSayAndNamesLineAndColumnOfWhatIsWrong) {
    double share = 0.0;
    double since = 7.0;
    const auto list = [&](const auto& cell) {
        cell({.front = "share", .holds = Holds::Share}, share);
        cell({.front = "since", .later = true}, since);
    };
    stored::readCells(CsvTable("share\n0.5\n", "a.csv"), 0, list);
    EXPECT_EQ(share, 0.5);
    EXPECT_EQ(since, 7.0);
    try {
        stored::readCells(CsvTable("share\n1.5\n", "a.csv"), 0, list);
        FAIL() << "a share above 1 is none";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "a.csv: line 2: share must be a share from 0 to 1");
    }
    EXPECT_THROW(stored::readCells(CsvTable("since\n1\n", "a.csv"), 0, list), InputError);
}

}  // namespace
}  // namespace asperity
