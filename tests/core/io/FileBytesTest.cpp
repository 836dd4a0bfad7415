#include "core/io/FileBytes.h"

#include "core/Error.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/OpenFilesLimit.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sys/stat.h>

namespace asperity::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Makes the time stamp another one, however coarse the file system's clock is.
void touch(const std::filesystem::path& path) {
    std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) +
                                               std::chrono::seconds(1));
}

}  // namespace

TEST(FileBytes, AreReadFromAnyOffset) {
    const ScratchFolder folder;
    const FileBytes file(folder.write("digits", "0123456789"));
    std::array<char, 3> bytes{};
    file.read(4, bytes);
    EXPECT_EQ(std::string(bytes.data(), 3), "456");
    EXPECT_EQ(file.start(4), "0123");
    EXPECT_EQ(file.start(100), "0123456789");
    EXPECT_NO_THROW(file.requireUnchanged());
}

TEST(FileBytes, RefusesAFileThatBecameShorter) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.write("scan", std::string(100000, 'x'));
    const FileBytes file(path);
    std::filesystem::resize_file(path, 50000);
    std::vector<char> bytes(60000);
    EXPECT_THAT(refusalOf([&] { file.read(0, bytes); }),
                AllOf(HasSubstr("scan: byte 50000: "), HasSubstr("shorter while it was read")));
    EXPECT_THAT(refusalOf([&] { file.requireUnchanged(); }), HasSubstr("was changed"));
}

TEST(FileBytes, KnowsWhenAFileWasWrittenTo) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.write("scan", "0123456789");
    const FileBytes file(path);
    std::fstream(path) << "98765";
    touch(path);
    EXPECT_THAT(refusalOf([&] { file.requireUnchanged(); }), HasSubstr("scan: the file was"));
}

TEST(FileBytes, StaysWithTheFileThatItOpened) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.write("scan", "before");
    const FileBytes file(path);
    std::filesystem::rename(folder.write("new", "another"), path);
    EXPECT_EQ(file.start(6), "before");
    EXPECT_NO_THROW(file.requireUnchanged());
}

TEST(FileBytes, RefusesWhatIsNoFile) {
    const ScratchFolder folder;
    const std::filesystem::path pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(FileBytes{pipe}, InputError);
    EXPECT_THROW(FileBytes{folder.path()}, InputError);
    EXPECT_THROW(FileBytes{folder.file("none")}, InputError);
    EXPECT_THROW(FileBytes{folder.write("empty", "")}, InputError);
}

/// All was a question: is the disk full?
TEST(FileBytes, SaysWhyACopyCannotBeWritten) {
    const ScratchFolder folder;
    const std::string text(100000, 'x');
    const MemoryBytes content(text, "scan");
    {
        const FileSizeLimit full(50000);
        EXPECT_THAT([&] { copyTo(content, folder.file("large")); },
                    ThrowsMessage<Error>(HasSubstr("large: cannot be written: File too large")));
    }
    const OpenFilesLimit none;
    EXPECT_THAT([&] { copyTo(content, folder.file("copy")); },
                ThrowsMessage<Error>(HasSubstr("copy: cannot be written: Too many open files")));
}

}  // namespace asperity::test
