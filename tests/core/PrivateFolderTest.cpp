#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/TemporaryFile.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sys/resource.h>
#include <thread>

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// The folder for temporary files is one of the test's own.
class PrivateFolderTest : public testing::Test {
protected:
    PrivateFolderTest() { setenv("TMPDIR", scratch.path().c_str(), 1); }
    ~PrivateFolderTest() override {
        before_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before_.c_str(), 1);
    }

    static std::string before() {
        const char* const given = std::getenv("TMPDIR");
        return given == nullptr ? "" : given;
    }

    const std::string before_ = before();
    const test::ScratchFolder scratch;
};

TEST_F(PrivateFolderTest, IsForItsOwnerAloneAndGoesWithWhatIsInIt) {
    {
        const PrivateFolder folder;
        EXPECT_EQ(folder.path().parent_path(), scratch.path());
        EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
        std::ofstream(folder.path() / "file") << "text";
    }
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST_F(PrivateFolderTest, SweepsThoseOfKilledProcessesAndNoOther) {
    const fs::path left = scratch.file(temporaryName(temporaryPrefix("private")));
    fs::create_directory(left);
    std::ofstream(left / "file") << "text";
    const fs::path mine = scratch.write("mine", "text");
    const PrivateFolder held;
    const PrivateFolder other;
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(mine));
    EXPECT_TRUE(fs::exists(held.path())) << "it is in use";
}

/// One of two programs that were started together said now and then that TMPDIR cannot be written:
/// the other one had swept its new folder before it was locked.
TEST_F(PrivateFolderTest, IsMadeWhileAnotherProgramSweeps) {
    const std::jthread sweeper([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            sweepLeftovers(scratch.path(), temporaryPrefix("private"));
            // Programs sweep once, before they make one; without a pause none stays.
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
    });
    for (int i = 0; i < 2000; ++i) {
        const PrivateFolder folder;
        ASSERT_TRUE(fs::exists(folder.path())) << i;
    }
}

TEST_F(PrivateFolderTest, SaysWhereItCannotBeMade) {
    setenv("TMPDIR", scratch.file("none").c_str(), 1);
    try {
        const PrivateFolder folder;
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("TMPDIR"));
    }
}

/// It left a folder for each of its tries.
TEST_F(PrivateFolderTest, LeavesNothingWhereItCannotBeOpened) {
    struct rlimit before {};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const FileDescriptor next(open("/dev/null", O_RDONLY | O_CLOEXEC));
    const rlimit none{static_cast<rlim_t>(next.get() + 1), before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    std::string refusal;
    try {
        const PrivateFolder folder;
    } catch (const FileError& error) {
        refusal = error.what();
    }
    setrlimit(RLIMIT_NOFILE, &before);
    EXPECT_EQ(refusal, scratch.path().string() + ": cannot be written: Too many open files");
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace asperity
