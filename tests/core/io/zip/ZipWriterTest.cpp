#include "core/io/zip/ZipWriter.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/zip/ZipArchive.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

namespace asperity::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr std::uint64_t kMax = 1U << 20U;

/// Message of an action that cannot write; empty when it can.
template <typename Action>
std::string writingError(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ZipWriter, WritesWhatIsReadBack) {
    const ScratchFolder scratch;
    const std::string noise(100'000, 'a');
    ZipWriter zip(scratch.file("a.zip"));
    zip.addFile("scan/größe.gsf", scratch.write("a.txt", noise));
    zip.addFile("scene.toml", scratch.write("b.txt", "[sample]\n"));
    EXPECT_FALSE(fs::exists(scratch.file("a.zip"))) << "before it is whole";
    zip.close();
    const FileBytes bytes(scratch.file("a.zip"));
    const ZipArchive archive(bytes);
    ASSERT_NE(archive.find("scan/größe.gsf"), nullptr);
    EXPECT_EQ(archive.decoded(*archive.find("scan/größe.gsf"), kMax), noise);
    EXPECT_EQ(archive.decoded(*archive.find("scene.toml"), kMax), "[sample]\n");
    EXPECT_EQ(archive.entries().size(), 2U);
}

TEST(ZipWriter, LeavesWhatWasThereUntilItIsWhole) {
    const ScratchFolder scratch;
    const fs::path target = scratch.write("a.zip", "earlier");
    {
        ZipWriter zip(target);
        zip.addFile("a", scratch.write("a.txt", "a"));
    }
    EXPECT_EQ(contentOf(target), "earlier");
    {
        ZipWriter zip(target);
        zip.addFile("a", scratch.file("missing"));
        EXPECT_THAT(writingError([&] { zip.close(); }), HasSubstr("a.zip: cannot be written"));
    }
    EXPECT_EQ(contentOf(target), "earlier");
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 2);
}

TEST(ZipWriter, CanBeCanceled) {
    const ScratchFolder scratch;
    const fs::path target = scratch.write("a.zip", "earlier");
    CanceledAfter progress(1);
    {
        ZipWriter zip(target);
        for (const char* name : {"a", "b", "c"}) {
            zip.addFile(name, scratch.write(name, std::string(3'000'000, *name)));
        }
        EXPECT_THROW(zip.close(&progress), Canceled);
    }
    EXPECT_EQ(contentOf(target), "earlier");
}

TEST(ZipWriter, RefusesAFolderThatIsNotThere) {
    const ScratchFolder scratch;
    EXPECT_THAT(writingError([&] { const ZipWriter zip(scratch.file("none") / "a.zip"); }),
                HasSubstr("cannot be"));
}

}  // namespace
}  // namespace asperity::test
