#include "app/reports/page/ReportPage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace asperity {
namespace {

TEST(PageNames, AreThoseOfTheFolders) {
    PageNames names("index");
    EXPECT_EQ(names.nameFor("runs/first"), "first");
    EXPECT_EQ(names.nameFor("runs/second/"), "second");
    EXPECT_EQ(names.nameFor("runs/third/."), "third");
    EXPECT_EQ(names.nameFor("./runs/x/../fourth"), "fourth");
    EXPECT_EQ(names.nameFor("."), std::filesystem::current_path().filename().string());
}

TEST(PageNames, DifferOnEveryFileSystem) {
    PageNames names("index");
    EXPECT_EQ(names.nameFor("a/run"), "run");
    EXPECT_EQ(names.nameFor("b/run"), "run_2");
    EXPECT_EQ(names.nameFor("c/Run"), "Run_3");
    EXPECT_EQ(names.nameFor("d/run_2"), "run_2_2");
    EXPECT_EQ(names.nameFor("d/Index"), "Index_2") << "the list of runs has that name";
}

TEST(PageNames, HoldNothingThatAFileOrALinkCannotHave) {
    PageNames names("index");
    EXPECT_EQ(names.nameFor("a b:c*d?\"<>|"), "a_b_c_d_____");
    EXPECT_EQ(names.nameFor("line\nbreak"), "line_break");
    EXPECT_EQ(names.nameFor(".hidden"), "run.hidden");
    EXPECT_EQ(names.nameFor("-option"), "run-option");
    EXPECT_EQ(names.nameFor("Prüfung"), "Prüfung");
    EXPECT_EQ(names.nameFor("\xff\xfe"), "__");
    EXPECT_EQ(names.nameFor("/"), "run");
    EXPECT_LE(names.nameFor(std::string(300, 'x')).size(), 104U);
}

}  // namespace
}  // namespace asperity
