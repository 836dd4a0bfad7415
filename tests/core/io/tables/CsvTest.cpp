#include "core/Error.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string tableRefusal(const std::string& content) {
    return refusalOf([&] { (void)CsvTable(content, "t.csv"); });
}

}  // namespace

TEST(CsvTable, ReadsNumbersAndTextByColumnName) {
    const CsvTable table("# made by hand\nx_m, state ,y_m\n1.5,stuck,-2e-9\n\n# more\nnan,\"a, "
                         "\"\"b\"\"\",inf\r\n",
                         "t.csv");
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"x_m", "state", "y_m"}));
    EXPECT_EQ(table.number(0, "x_m"), 1.5);
    EXPECT_EQ(table.number(0, "y_m"), -2e-9);
    EXPECT_EQ(table.text(1, "state"), "a, \"b\"");
    EXPECT_TRUE(std::isnan(table.number(1, "x_m")));
    EXPECT_EQ(table.numbers("y_m")[1], std::numeric_limits<double>::infinity());
    EXPECT_EQ(table.line(1), 6U);
}

TEST(CsvTable, TakesAByteOrderMarkAndALineWithoutEnd) {
    const CsvTable table("\xEF\xBB\xBFx\n7", "t.csv");
    EXPECT_EQ(table.number(0, "x"), 7.0);
}

TEST(CsvTable, ReadsRenamedColumnsByTheirCurrentNames) {
    const CsvTable table("hand_z_m,base_z_m\n1,2\n", "t.csv");
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"device_z_m", "base_z_m"}));
    EXPECT_EQ(table.number(0, "device_z_m"), 1.0);
    EXPECT_FALSE(table.has("hand_z_m"));
    const CsvTable both("hand_z_m,device_z_m\n1,2\n", "t.csv");
    EXPECT_EQ(both.number(0, "hand_z_m"), 1.0);
    EXPECT_EQ(both.number(0, "device_z_m"), 2.0);
    EXPECT_THAT(tableRefusal("hand_z_m,hand_z_m\n"), HasSubstr("two columns 'device_z_m'"));
}

TEST(CsvTable, RefusalsNameFileAndLine) {
    EXPECT_THAT(tableRefusal("a,b\n1,2\n3\n"),
                AllOf(HasSubstr("t.csv: line 3: "), HasSubstr("2 cells"), HasSubstr("found 1")));
    EXPECT_THAT(tableRefusal("# only comments\n"), HasSubstr("t.csv: "));
    EXPECT_THAT(tableRefusal("a,a\n"), HasSubstr("two columns 'a'"));
    EXPECT_THAT(tableRefusal("a,\n1,2\n"), HasSubstr("no name"));
    EXPECT_THAT(tableRefusal("a\n\"open\n"), HasSubstr("line 2: a quoted cell"));
    const CsvTable table("a,b\n1,2\n# note\n3,four\n", "t.csv");
    EXPECT_THAT(refusalOf([&] { (void)table.number(1, "b"); }),
                AllOf(HasSubstr("t.csv: line 4: "), HasSubstr("'four'")));
    EXPECT_THAT(refusalOf([&] { (void)table.numbers("b"); }), HasSubstr("line 4"));
    EXPECT_THAT(refusalOf([&] { (void)table.number(0, "c"); }), HasSubstr("no column 'c'"));
    EXPECT_THAT(refusalOf([] { (void)readCsv("/nowhere/t.csv"); }), HasSubstr("no such file"));
}

TEST(CsvWriter, NumbersReadBackToTheSameBits) {
    const ScratchFolder folder;
    const std::vector<double> values = {0.1, -1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0};
    CsvWriter writer(folder.file("t.csv"), {"asperity", "SI units"}, {"a", "b", "c", "d", "e"});
    writer.row(values);
    writer.close();
    const CsvTable table = readCsv(folder.file("t.csv"));
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(table.number(0, table.columns()[i]), values[i]);
        EXPECT_EQ(std::signbit(table.number(0, table.columns()[i])), std::signbit(values[i]));
    }
}

TEST(CsvWriter, WritesCommentsHeaderAndSeventeenDigits) {
    std::ostringstream stream;
    CsvWriter writer(stream, {"asperity 0.1"}, {"gap_m", "state"});
    writer.add(0.1).add("snap, in").endRow();
    writer.add(std::numeric_limits<double>::quiet_NaN()).add("").endRow();
    writer.close();
    EXPECT_EQ(stream.str(),
              "# asperity 0.1\ngap_m,state\n0.10000000000000001,\"snap, in\"\nnan,\n");
}

/// A terminal that shows the table would obey them.
TEST(CsvWriter, WritesNoCharacterThatATerminalObeys) {
    std::ostringstream text;
    CsvWriter csv(text, {}, {"material"});
    csv.add("gold\x1B[31m\a").endRow();
    csv.add("größe, µm").endRow();
    csv.close();
    EXPECT_EQ(text.str(), "material\ngold\\e[31m\\x07\n\"größe, µm\"\n");
}

TEST(CsvWriter, RefusesARowOfAnotherLength) {
    std::ostringstream stream;
    CsvWriter writer(stream, {}, {"a", "b"});
    EXPECT_THROW(writer.row(std::array{1.0}), Error);
}

TEST(CsvWriter, LeavesWhatWasThereUnlessClosed) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.write("t.csv", "old\n");
    {
        CsvWriter writer(path, {}, {"a"});
        writer.row(std::array{1.0});
    }
    EXPECT_EQ(contentOf(path), "old\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(CsvWriter, KeepsManyRows) {
    const ScratchFolder folder;
    CsvWriter writer(folder.file("t.csv"), {}, {"i", "root"});
    for (int i = 0; i < 100000; ++i) {
        writer.row(std::array{static_cast<double>(i), std::sqrt(static_cast<double>(i))});
    }
    writer.close();
    const std::vector<double> roots = readCsv(folder.file("t.csv")).numbers("root");
    ASSERT_EQ(roots.size(), 100000U);
    EXPECT_EQ(roots[99999], std::sqrt(99999.0));
}

}  // namespace asperity::test
