#include "core/TemporaryFile.h"

#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <sys/stat.h>

namespace asperity {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& target, const std::string& text) {
    OutputFile file(target);
    file.stream() << text;
    file.commit();
}

long filesIn(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(TemporaryFile, TakesTheTargetsPlaceOnlyWhenCommitted) {
    const test::ScratchFolder scratch;
    const fs::path target = scratch.write("out.txt", "before");
    {
        OutputFile file(target);
        file.stream() << "after";
    }
    EXPECT_EQ(test::contentOf(target), "before");
    write(target, "after");
    EXPECT_EQ(test::contentOf(target), "after");
    EXPECT_EQ(filesIn(scratch.path()), 1);
}

TEST(TemporaryFile, FollowsALinkToItsPlace) {
    const test::ScratchFolder scratch;
    fs::create_directory(scratch.file("far"));
    fs::create_symlink("far/out.txt", scratch.file("link"));
    fs::create_symlink(scratch.file("link"), scratch.file("second"));
    for (const char* link : {"second", "link"}) {
        for (const std::string text : {"first", "over it"}) {
            write(scratch.file(link), text);
            EXPECT_EQ(test::contentOf(scratch.file("far/out.txt")), text);
        }
        fs::remove(scratch.file("far/out.txt"));
        EXPECT_TRUE(fs::is_symlink(scratch.file(link)));
    }
    EXPECT_EQ(filesIn(scratch.path()), 3);
}

TEST(TemporaryFile, RefusesWhatIsThereAndNoRegularFile) {
    const test::ScratchFolder scratch;
    fs::create_directory(scratch.file("folder"));
    ASSERT_EQ(mkfifo(scratch.file("pipe").c_str(), 0600), 0);
    fs::create_symlink("pipe", scratch.file("link"));
    fs::create_symlink("loop", scratch.file("loop"));
    for (const char* name : {"folder", "pipe", "link", "loop"}) {
        EXPECT_THROW(TemporaryFile{scratch.file(name)}, Error) << name;
        EXPECT_THROW(requireWritable(scratch.file(name)), Error) << name;
    }
    EXPECT_TRUE(fs::is_fifo(scratch.file("pipe")));
    EXPECT_EQ(filesIn(scratch.path()), 4);
}

TEST(TemporaryFile, AskingWhetherItCanBeWrittenLeavesNothing) {
    const test::ScratchFolder scratch;
    EXPECT_NO_THROW(requireWritable(scratch.file("out.txt")));
    EXPECT_THROW(requireWritable(scratch.file("none/out.txt")), Error);
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace asperity
