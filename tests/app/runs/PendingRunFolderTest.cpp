#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

namespace asperity {
namespace {

namespace fs = std::filesystem;

class PendingRunFolders : public ::testing::Test {
protected:
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        writeTextFile(folder / name, text);
    }
    [[nodiscard]] std::string content(const std::string& name) const {
        return test::contentOf(folder / name);
    }

    test::ScratchFolder scratch;
    fs::path folder = scratch.file("run");
};

/// The one that came second took the files of the first away when it gave up.
TEST_F(PendingRunFolders, HaveTheirFolderToThemselves) {
    auto first = std::make_unique<PendingRunFolder>(folder, false);
    write(run_files::kMemory, "first");
    EXPECT_THROW(PendingRunFolder(folder, false), Error);
    EXPECT_THROW(PendingRunFolder(folder, true), Error);
    EXPECT_THROW(OutputFolder(folder, {.own = {run_files::kMemory}, .guarded = {}}, true), Error);
    EXPECT_EQ(content(run_files::kMemory), "first");
    first->keep();
    first.reset();
    EXPECT_THROW(PendingRunFolder(folder, false), Error) << "there is a run in it";
    EXPECT_EQ(content(run_files::kMemory), "first");
    PendingRunFolder(folder, true);
    EXPECT_EQ(content(run_files::kMemory), "first");
}

TEST_F(PendingRunFolders, LeaveNothingWithoutBeingKept) {
    { const PendingRunFolder run(folder, false); }
    EXPECT_FALSE(fs::exists(folder));
    { const OutputFolder out(folder, {.own = {"table.csv"}, .guarded = {}}); }
    EXPECT_FALSE(fs::exists(folder));
    fs::create_directory(folder);
    { const PendingRunFolder run(folder, false); }
    EXPECT_TRUE(fs::exists(folder)) << "it was there before";
}

TEST_F(PendingRunFolders, LeaveWhatAKilledOneHadSetAside) {
    write("replaced_run/tick_input.csv", "of a killed one");
    write(run_files::kInput, "earlier");
    {
        const PendingRunFolder run(folder, true);
        EXPECT_FALSE(fs::exists(folder / run_files::kInput));
        write(run_files::kInput, "new");
    }
    EXPECT_EQ(content(run_files::kInput), "earlier");
    {
        PendingRunFolder run(folder, true);
        write(run_files::kInput, "new");
        run.keep();
    }
    EXPECT_EQ(content(run_files::kInput), "new");
    EXPECT_EQ(content("replaced_run/tick_input.csv"), "of a killed one");
    EXPECT_FALSE(fs::exists(folder / "replaced_run_2"));
}

}  // namespace
}  // namespace asperity
