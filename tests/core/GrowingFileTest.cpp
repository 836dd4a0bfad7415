#include "core/GrowingFile.h"

#include "core/Error.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

TEST(GrowingFile, HoldsAtOnceWhatWasAppended) {
    const test::ScratchFolder scratch;
    GrowingFile file(scratch.file("table.csv"));
    file.append("one\n");
    EXPECT_EQ(test::contentOf(scratch.file("table.csv")), "one\n");
    file.append("two\n");
    EXPECT_NO_THROW(file.sync());
    EXPECT_EQ(test::contentOf(scratch.file("table.csv")), "one\ntwo\n");
}

TEST(GrowingFile, IsSeenToGrowWhileItIsOpen) {
    const test::ScratchFolder scratch;
    EXPECT_FALSE(isGrowing(scratch.file("table.csv")));
    {
        const GrowingFile file(scratch.file("table.csv"));
        EXPECT_TRUE(isGrowing(scratch.file("table.csv")));
    }
    EXPECT_FALSE(isGrowing(scratch.file("table.csv")));
}

TEST(GrowingFile, GoesOnAfterWhatItKeeps) {
    const test::ScratchFolder scratch;
    const auto path = scratch.write("rows", "one\ntw");
    {
        GrowingFile file(path, 4);
        file.append("two\n");
        EXPECT_TRUE(isGrowing(path));
        EXPECT_THROW(GrowingFile(path, 0), Error);
    }
    EXPECT_EQ(test::contentOf(path), "one\ntwo\n");
    EXPECT_THROW(GrowingFile(scratch.file("missing"), 0), Error);
}

TEST(GrowingFile, WritesOverNothing) {
    const test::ScratchFolder scratch;
    const auto victim = scratch.write("victim", "precious");
    std::filesystem::create_symlink("victim", scratch.file("link"));
    std::filesystem::create_symlink("nowhere", scratch.file("dangling"));
    for (const char* name : {"victim", "link", "dangling"}) {
        EXPECT_THROW(GrowingFile{scratch.file(name)}, Error) << name;
    }
    EXPECT_EQ(test::contentOf(victim), "precious");
    EXPECT_FALSE(std::filesystem::exists(scratch.file("nowhere")));
}

TEST(GrowingFile, SaysWhyItCannotGrow) {
    const test::ScratchFolder scratch;
    GrowingFile file(scratch.file("table.csv"));
    const test::FileSizeLimit full(10);
    file.append("one\n");
    try {
        file.append("two\nthree\n");
        FAIL() << "there is room for two bytes more";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("table.csv: cannot be written: File too large"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_TRUE(test::contentOf(scratch.file("table.csv")).starts_with("one\ntwo\n"));
}

}  // namespace
}  // namespace asperity
