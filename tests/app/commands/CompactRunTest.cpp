#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace asperity {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A run in the compact format, and the same run as text.
class CompactRun : public testing::Test {
protected:
    static void SetUpTestSuite() {
        scratch = std::make_unique<test::ScratchFolder>();
        for (const auto& [format, folder] :
             {std::pair("h5", "compact"), std::pair("csv", "text")}) {
            const auto made = test::runProgram(
                "explore --no-pictures " + test::shippedScene("polystyrene").string() +
                " --duration 3 --format " + format + " --out " + scratch->file(folder).string());
            ASSERT_EQ(made.exitCode, 0) << made.output;
        }
    }
    static void TearDownTestSuite() { scratch.reset(); }

    static test::ProgramRun run(const std::string& arguments) {
        return test::runProgram(arguments);
    }
    static std::string in(const char* name) { return scratch->file(name).string(); }

    static test::ProgramRun replayWithAdhesion(const std::string& work) {
        fs::remove_all(scratch->file("altered"));
        fs::copy(scratch->file("compact"), scratch->file("altered"));
        std::string scene = test::contentOf(scratch->file("altered") / "scene.toml");
        const std::string key = "work_of_adhesion_j_m2 = ";
        EXPECT_NE(scene.find(key), std::string::npos);
        const std::size_t digits = scene.find(key) + key.size();
        scene.replace(digits, scene.find('\n', digits) - digits, work);
        std::ofstream(scratch->file("altered") / "scene.toml") << scene;
        return run("replay " + in("altered") + " --out " + in("other"));
    }

    static std::unique_ptr<test::ScratchFolder> scratch;
};

std::unique_ptr<test::ScratchFolder> CompactRun::scratch;

TEST_F(CompactRun, IsATenthOfTheText) {
    EXPECT_FALSE(fs::exists(scratch->file("compact") / "force_log.csv"));
    EXPECT_FALSE(fs::exists(scratch->file("compact") / "tick_input.csv"));
    const auto text = fs::file_size(scratch->file("text") / "force_log.csv") +
                      fs::file_size(scratch->file("text") / "tick_input.csv");
    EXPECT_LT(10 * fs::file_size(scratch->file("compact") / "recording.h5"), text);
}

TEST_F(CompactRun, ReplaysBitIdentically) {
    const auto again = run("replay " + in("compact") + " --out " + in("again"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical: 3001 ticks"));
    EXPECT_EQ(test::contentOf(scratch->file("again") / "force_log.csv"),
              test::contentOf(scratch->file("text") / "force_log.csv"));
}

TEST_F(CompactRun, IsConvertedToTextAndBackToTheSameBytes) {
    const auto text = run("convert " + in("compact") + " " + in("back") + " --format csv");
    EXPECT_EQ(text.exitCode, 0) << text.output;
    for (const char* name : {"force_log.csv", "tick_input.csv", "summary.json", "scene.toml"}) {
        EXPECT_EQ(test::contentOf(scratch->file("back") / name),
                  test::contentOf(scratch->file("text") / name))
            << name;
    }
    const auto packed = run("convert " + in("back") + " " + in("packed") + " --format h5");
    EXPECT_EQ(packed.exitCode, 0) << packed.output;
    EXPECT_EQ(test::contentOf(scratch->file("packed") / "recording.h5"),
              test::contentOf(scratch->file("compact") / "recording.h5"));
}

TEST_F(CompactRun, IsConvertedOntoNoOtherRunUnasked) {
    const auto other =
        test::runProgram("explore --no-pictures " + test::shippedScene("granular_film").string() +
                         " --duration 0.1 --out " + in("theirs"));
    ASSERT_EQ(other.exitCode, 0) << other.output;
    fs::create_directory(scratch->file("lone"));
    fs::copy_file(scratch->file("compact") / "recording.h5",
                  scratch->file("lone") / "recording.h5");
    for (const auto& [from, to, format, kept] :
         {std::tuple("text", "theirs", "h5", "force_log.csv"),
          std::tuple("compact", "lone", "csv", "recording.h5")}) {
        const std::string before = test::contentOf(scratch->file(to) / kept);
        const std::string call = "convert " + in(from) + " " + in(to) + " --format " + format;
        const auto refused = run(call);
        EXPECT_EQ(refused.exitCode, 1) << call;
        EXPECT_THAT(refused.output, HasSubstr("--force"));
        EXPECT_EQ(test::contentOf(scratch->file(to) / kept), before) << call;
        EXPECT_EQ(run(call + " --force").exitCode, 0) << call;
        EXPECT_FALSE(fs::exists(scratch->file(to) / kept)) << call;
    }
}

TEST_F(CompactRun, IsNamedAsGivenWhereTheDiskIsFull) {
    const auto full = test::runProgram("convert " + in("text") + " " + in("full") + " --format h5",
                                       "ulimit -f 200;");
    EXPECT_EQ(full.exitCode, 1) << full.output;
    EXPECT_EQ(full.output.rfind("asperity: " + in("full") + "/", 0), 0U) << full.output;
    EXPECT_THAT(full.output, HasSubstr(".csv: cannot be written: File too large\n"));
    EXPECT_FALSE(fs::exists(scratch->file("full")));
}

/// Where too few files may be open, folders stayed, and the sentence named one that nobody knows.
TEST_F(CompactRun, LeavesNothingWhereTooManyFilesAreOpen) {
    const fs::path temporary = scratch->file("temporary");
    fs::create_directory(temporary);
    for (const std::string& call :
         {"replay " + in("compact"), "replay " + in("text"),
          "explore --no-pictures --duration 0.1 " + test::shippedScene("polystyrene").string()}) {
        int refused = 0;
        int done = 0;
        for (int files = 4; files < 16; ++files) {
            const auto ended = test::runProgram(call + " --out " + in("few"),
                                                "ulimit -n " + std::to_string(files) +
                                                    "; TMPDIR=" + temporary.string());
            refused += ended.exitCode == 0 ? 0 : 1;
            done += ended.exitCode == 0 ? 1 : 0;
            EXPECT_EQ(fs::exists(scratch->file("few")), ended.exitCode == 0)
                << files << " files: " << ended.output;
            EXPECT_TRUE(fs::is_empty(temporary)) << files << " files: " << ended.output;
            EXPECT_EQ(ended.output.find(".part"), std::string::npos) << ended.output;
            fs::remove_all(scratch->file("few"));
        }
        EXPECT_GT(refused, 0) << call;
        EXPECT_GT(done, 0) << call;
    }
}

TEST_F(CompactRun, IsNamedWhereTooManyFilesAreOpenToReadIt) {
    for (int files = 4; files < 16; ++files) {
        const auto ended =
            test::runProgram("convert " + in("compact") + " " + in("few") + " --format csv",
                             "ulimit -n " + std::to_string(files) + ";");
        fs::remove_all(scratch->file("few"));
        if (ended.output.find("it cannot be read") != std::string::npos) {
            EXPECT_EQ(ended.exitCode, 3) << ended.output;
            EXPECT_THAT(ended.output, HasSubstr("compact/recording.h5: it cannot be read: "));
            EXPECT_THAT(ended.output, HasSubstr("Too many open files"));
        }
    }
}

TEST_F(CompactRun, IsNotConvertedInVain) {
    const auto same = run("convert " + in("compact") + " " + in("same") + " --format h5");
    EXPECT_EQ(same.exitCode, 1);
    EXPECT_THAT(same.output, HasSubstr("have this format already"));
    const auto itself = run("convert " + in("compact") + " " + in("compact") + " --format csv");
    EXPECT_EQ(itself.exitCode, 1);
    const auto noRun = run("convert " + scratch->path().string() + " " + in("x") + " --format csv");
    EXPECT_EQ(noRun.exitCode, 3);
    const auto map =
        run("convert " + in("compact") + " " + in("x") + " --format csv --level plane");
    EXPECT_EQ(map.exitCode, 2);
    EXPECT_FALSE(fs::exists(scratch->file("same")));
    EXPECT_FALSE(fs::exists(scratch->file("x")));
}

TEST_F(CompactRun, ReplacesAnotherRunAndIsReplaced) {
    const std::string explore = "explore --no-pictures " +
                                test::shippedScene("polystyrene").string() +
                                " --duration 0.1 --out " + in("replaced");
    ASSERT_EQ(run(explore).exitCode, 0);
    ASSERT_EQ(run(explore + " --format h5").exitCode, 0);
    EXPECT_FALSE(fs::exists(scratch->file("replaced") / "tick_input.csv"));
    ASSERT_EQ(run(explore).exitCode, 0);
    EXPECT_FALSE(fs::exists(scratch->file("replaced") / "recording.h5"));
    EXPECT_TRUE(fs::exists(scratch->file("replaced") / "tick_input.csv"));
}

TEST_F(CompactRun, NamesWhereAReplayDiffers) {
    const auto again = replayWithAdhesion("0.067");
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.output, HasSubstr("first differing tick: "));
    EXPECT_THAT(again.output, HasSubstr(" was "));
}

TEST_F(CompactRun, IsCheckedBeyondTheDigitsThatItsLogKeeps) {
    const auto again = replayWithAdhesion("0.0660000000000001");
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.output, HasSubstr("in digits beyond single precision"));
}

TEST_F(CompactRun, IsWhatALoopRecordsAtItsEnd) {
    const auto loop = run("loop " + test::shippedScene("polystyrene").string() +
                          " --duration 2 --format h5 --record " + in("loop"));
    ASSERT_EQ(loop.exitCode, 0) << loop.output;
    EXPECT_TRUE(fs::exists(scratch->file("loop") / "recording.h5"));
    EXPECT_FALSE(fs::exists(scratch->file("loop") / "force_log.csv"));
    const auto again = run("replay " + in("loop") + " --out " + in("loop_again"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical: "));
}

}  // namespace
}  // namespace asperity
