#include "core/io/tables/CsvTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CsvRows, ComeOneAfterTheOther) {
    const ScratchFolder scratch;
    CsvRows rows(scratch.write("a.csv", "# first\n#second\na,b\n1, \"x, \"\"y\"\"\"\n\n# no "
                                        "comment of the table\n-2e-9,\r\n"));
    EXPECT_THAT(rows.comments(), ElementsAre("first", "second"));
    EXPECT_THAT(rows.columns(), ElementsAre("a", "b"));
    ASSERT_TRUE(rows.next());
    EXPECT_THAT(rows.cells(), ElementsAre("1", "x, \"y\""));
    ASSERT_TRUE(rows.next());
    EXPECT_THAT(rows.cells(), ElementsAre("-2e-9", ""));
    EXPECT_FALSE(rows.next());
}

TEST(CsvRows, AreRefusedWithTheirLine) {
    const ScratchFolder scratch;
    const auto refusal = [&scratch](const char* content) {
        return refusalOf([&] {
            CsvRows rows(scratch.write("a.csv", content));
            while (rows.next()) {
            }
        });
    };
    EXPECT_THAT(refusal("# only\n"), HasSubstr("expected a line that names the columns"));
    EXPECT_THAT(refusal("a,b\n1,2\n3\n"), HasSubstr("line 3"));
    EXPECT_THAT(refusal("a,b\n1,\"2\n"), HasSubstr("a quoted cell is not closed"));
    EXPECT_THAT(refusal((std::string(20'000, ',') + "\n").c_str()),
                HasSubstr("expected at most 10000 columns, found 20001"));
}

/// A row of three million commas took a hundred megabytes before it was refused.
TEST(CsvRows, KeepNoCellBeyondTheColumns) {
    std::vector<std::string> cells{"of", "an", "earlier", "row"};
    EXPECT_EQ(splitCells("1, \"2,\", 3,4,5", 2, cells), 5U);
    EXPECT_THAT(cells, ElementsAre("1", "2,"));
    EXPECT_EQ(splitCells("1", 2, cells), 1U);
    EXPECT_THAT(cells, ElementsAre("1"));
    EXPECT_EQ(splitCells("1,\"", 2, cells), 0U);
}

}  // namespace
}  // namespace asperity::test
