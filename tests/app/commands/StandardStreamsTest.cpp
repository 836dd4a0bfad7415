#include "tests/app/ProgramRun.h"
#include "tests/support/Places.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace asperity {
namespace {

/// Runs the program without the streams, but not for ever. @return its exit code, as a word
std::string exitWithout(const std::string& streams, const std::string& arguments) {
    const test::ProgramRun run =
        test::runProgram(arguments + " " + streams + "; echo $?", "DISPLAY= timeout -s KILL 600");
    return run.output;
}

// The pipe to the display server replaced standard input, and explore never ended.
TEST(StandardStreams, ThatAreClosedAreNotTakenByFilesOfARun) {
    const test::ScratchFolder scratch;
    const std::filesystem::path out = scratch.file("results");
    EXPECT_EQ(exitWithout("<&- >&- 2>&-", "explore " + test::shippedScene("polystyrene").string() +
                                              " --duration 0.05 --out " + out.string()),
              "1\n")
        << "its last line could not be written";
    EXPECT_TRUE(std::filesystem::exists(out / "forces.png"));
    EXPECT_TRUE(std::filesystem::exists(out / "summary.json"));
}

TEST(StandardStreams, WithoutInputAndErrorARunIsAsEver) {
    const test::ScratchFolder scratch;
    EXPECT_EQ(exitWithout("<&- 2>&- >/dev/null",
                          "explore " + test::shippedScene("polystyrene").string() +
                              " --duration 0.05 --out " + scratch.file("results").string()),
              "0\n");
}

TEST(StandardStreams, AnAnswerThatNobodyGetsIsAFailure) {
    EXPECT_EQ(exitWithout(">&- 2>/dev/null",
                          "info " + test::dataFolder().string() + "/samples/steps.gsf"),
              "1\n");
}

/// "explore ... | head" ended without its results, and left a hidden folder among them.
TEST(StandardStreams, AReaderThatEndsFirstEndsNoRun) {
    const test::ScratchFolder scratch;
    const std::filesystem::path out = scratch.file("results");
    (void)exitWithout("2>&1 | true", "explore " + test::shippedScene("polystyrene").string() +
                                         " --duration 0.05 --out " + out.string());
    EXPECT_TRUE(std::filesystem::exists(out / "deformation.png"));
    ASSERT_TRUE(std::filesystem::exists(out / "summary.json"));
    for (const auto& entry : std::filesystem::directory_iterator(out)) {
        EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
    }
}

}  // namespace
}  // namespace asperity
