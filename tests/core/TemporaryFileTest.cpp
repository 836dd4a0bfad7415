#include "core/TemporaryFile.h"

#include "core/Error.h"
#include "tests/support/OpenFilesLimit.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

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

TEST(TemporaryFile, ReplacesTheTargetOnlyWhenCommitted) {
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

TEST(TemporaryFile, FollowsALinkToItsTarget) {
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
    EXPECT_THROW(requireWritable(scratch.file("none/out.txt")), FileError);
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

/// Leftovers of a killed process for a target.
fs::path leftover(const test::ScratchFolder& scratch, const std::string& target) {
    return scratch.write(temporaryName(temporaryPrefix(target)), "half");
}

TEST(TemporaryFile, HasANameThatNobodyCanPlantALinkAt) {
    const test::ScratchFolder scratch;
    const TemporaryFile one(scratch.file("out.txt"));
    const TemporaryFile other(scratch.file("out.txt"));
    EXPECT_NE(one.path(), other.path());
    EXPECT_EQ(one.path().parent_path(), scratch.path());
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(one.path())));
}

TEST(TemporaryFile, HasTheModeThatTheUmaskSays) {
    const test::ScratchFolder scratch;
    const mode_t before = umask(027);
    write(scratch.file("out.txt"), "text");
    umask(before);
    EXPECT_EQ(fs::status(scratch.file("out.txt")).permissions(), fs::perms(0640));
}

TEST(TemporaryFile, SweepsWhatAKilledProcessLeftForTheSameTarget) {
    const test::ScratchFolder scratch;
    leftover(scratch, "out.txt");
    const fs::path ofOther = leftover(scratch, "other.txt");
    const fs::path ofUser = scratch.write(".asperity-notes.part", "mine");
    const fs::path link = scratch.file(temporaryName(temporaryPrefix("out.txt")));
    fs::create_symlink("other.txt", link);
    write(scratch.file("out.txt"), "text");
    EXPECT_TRUE(fs::exists(ofOther));
    EXPECT_TRUE(fs::exists(ofUser));
    EXPECT_TRUE(fs::is_symlink(link)) << "no regular file";
    EXPECT_EQ(filesIn(scratch.path()), 4);
}

TEST(TemporaryFile, SweepsWhatWasWrittenForItsTemporary) {
    const test::ScratchFolder scratch;
    const std::string first = temporaryName(temporaryPrefix("out.txt"));
    (void)scratch.write(first, "half");
    (void)scratch.write(temporaryName(temporaryPrefix(first)), "piece of it");
    write(scratch.file("out.txt"), "text");
    EXPECT_EQ(filesIn(scratch.path()), 1);
}

TEST(TemporaryFile, IsNotSweptWhileItIsWritten) {
    const test::ScratchFolder scratch;
    OutputFile slow(scratch.file("out.txt"));
    slow.stream() << "slow";
    write(scratch.file("out.txt"), "fast");
    slow.commit();
    EXPECT_EQ(test::contentOf(scratch.file("out.txt")), "slow");
    EXPECT_EQ(filesIn(scratch.path()), 1);
}

TEST(TemporaryFolder, IsGoneThoughOthersSweepWhileItIsRemoved) {
    const test::ScratchFolder scratch;
    std::jthread sweeper([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            sweepLeftovers(scratch.path(), temporaryPrefix("work"));
            // Programs sweep once, before they make one; without a pause none stays.
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
    });
    int left = 0;
    for (int i = 0; i < 300; ++i) {
        fs::path path;
        {
            const TemporaryFolder folder(scratch.path(), "work");
            path = folder.path();
            for (int k = 0; k < 20; ++k) {
                std::ofstream(path / std::to_string(k)) << k;
            }
        }
        left += fs::exists(path) ? 1 : 0;
    }
    EXPECT_EQ(left, 0);
}

TEST(TemporaryFile, TakesNamesAsLongAsTheFileSystem) {
    const test::ScratchFolder scratch;
    for (const std::size_t length : {245U, 246U, 255U}) {
        const fs::path target = scratch.file(std::string(length, 'a'));
        write(target, "text");
        EXPECT_EQ(test::contentOf(target), "text") << length;
    }
    try {
        requireWritable(scratch.file(std::string(256, 'a')));
        FAIL() << "no file system has such names";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("File name too long"), std::string::npos)
            << error.what();
    }
}

/// A file that the writer could not open was reported as a full disk.
TEST(TemporaryFile, SaysThatTooManyFilesAreOpen) {
    const test::ScratchFolder scratch;
    std::string said;
    try {
        const test::OpenFilesLimit one(1);
        const OutputFile file(scratch.file("out.txt"));
    } catch (const FileError& error) {
        said = error.what();
    }
    EXPECT_NE(said.find("out.txt: cannot be written: Too many open files"), std::string::npos)
        << said;
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(TemporaryFile, SaysThatItsFolderIsMissing) {
    const test::ScratchFolder scratch;
    try {
        requireWritable(scratch.file("none/out.txt"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("its folder is missing"), std::string::npos);
    }
}

}  // namespace
}  // namespace asperity
