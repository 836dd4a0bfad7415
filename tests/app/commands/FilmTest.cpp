#include "core/io/tables/CsvTable.h"
#include "tests/app/ChildProgram.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/exports/OtherProgram.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace asperity {
namespace {

class Film : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        shared = std::make_unique<test::ScratchFolder>();
        (void)test::runProgram("explore --no-pictures " +
                               test::shippedScene("polystyrene").string() + " --duration 2 --out " +
                               run());
    }
    static void TearDownTestSuite() { shared.reset(); }

    static std::string run() { return (shared->path() / "run").string(); }
    static test::ProgramRun film(const std::string& arguments) {
        return test::runProgram("film " + run() + " --size 320x240 " + arguments);
    }

    /// Returns whether a file of a film lies there, under whatever name.
    [[nodiscard]] bool isWritten() const {
        const std::filesystem::recursive_directory_iterator files(scratch.path());
        return std::any_of(begin(files), end(files),
                           [](const auto& file) { return file.is_regular_file(); });
    }

    inline static std::unique_ptr<test::ScratchFolder> shared;
    test::ScratchFolder scratch;
};

TEST_F(Film, IsAFolderOfFramesWithTheirTable) {
    const auto out = scratch.path() / "frames";
    const auto ended = film("--duration 0.4 --out " + out.string());
    ASSERT_EQ(ended.exitCode, 0) << ended.output;
    const CsvTable table = readCsv(out / "frames.csv");
    ASSERT_EQ(table.rows(), 10U);
    EXPECT_EQ(table.number(0, "time_s"), 0.0);
    EXPECT_EQ(table.number(9, "time_s"), 2.0);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_TRUE(std::filesystem::exists(out / table.text(row, "frame")));
    }
    EXPECT_EQ(table.text(0, "frame"), "frame_00001.png");
    EXPECT_NE(test::contentOf(out / "frame_00001.png"), test::contentOf(out / "frame_00005.png"));
}

TEST_F(Film, ReplacesAnEarlierOneOnlyIfAskedAndWhole) {
    const auto out = scratch.path() / "frames";
    ASSERT_EQ(film("--duration 0.4 --out " + out.string()).exitCode, 0);
    EXPECT_EQ(film("--duration 0.2 --out " + out.string()).exitCode, 1);
    EXPECT_TRUE(std::filesystem::exists(out / "frame_00010.png"));
    EXPECT_EQ(film("--duration 0.2 --force --out " + out.string()).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(out / "frame_00005.png"));
    EXPECT_FALSE(std::filesystem::exists(out / "frame_00006.png"));
}

TEST_F(Film, IsAVideoByFfmpeg) {
    for (const char* name : {"a.mp4", "a.webm"}) {
        const auto out = scratch.path() / name;
        const auto ended = film("--duration 0.4 --out " + out.string());
        ASSERT_EQ(ended.exitCode, 0) << ended.output;
        EXPECT_EQ(test::outputOf("ffprobe -v error -count_frames -select_streams v -show_entries "
                                 "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 " +
                                 out.string()),
                  "320,240,25/1,10\n");
        EXPECT_EQ(film("--duration 0.4 --out " + out.string()).exitCode, 1);
    }
}

TEST_F(Film, LeavesNothingWhenItIsInterrupted) {
    for (const char* name : {"frames", "a.mp4"}) {
        test::ChildProgram program({"film", run(), "--size", "640x480", "--speed", "0.01", "--out",
                                    (scratch.path() / name).string()});
        while (!isWritten() && !program.hasEnded()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        EXPECT_FALSE(program.hasEnded());
        program.send(SIGINT);
        EXPECT_NE(program.wait().exitCode, 0);
        EXPECT_TRUE(std::filesystem::is_empty(scratch.path())) << name;
    }
}

TEST_F(Film, RefusesNonsenseInOneSentence) {
    const std::string out = " --out " + (scratch.path() / "a").string();
    EXPECT_EQ(film("--view forces" + out).exitCode, 1);
    EXPECT_EQ(film("--from 1.5 --to 1" + out).exitCode, 1);
    EXPECT_EQ(film("--from 9" + out).exitCode, 1);
    EXPECT_EQ(film("--speed 0" + out).exitCode, 2);
    EXPECT_EQ(film("--speed 1 --duration 3" + out).exitCode, 2);
    EXPECT_EQ(film("--fps 1000" + out).exitCode, 2);
    EXPECT_EQ(film("--out " + (scratch.path() / "a.avi").string()).exitCode, 1);
    EXPECT_EQ(film("--transparent --out " + (scratch.path() / "a.mp4").string()).exitCode, 1);
    const auto scene = test::runProgram("film " + test::shippedScene("polystyrene").string() + out);
    EXPECT_EQ(scene.exitCode, 3);
    EXPECT_NE(scene.output.find("is no folder of a run"), std::string::npos) << scene.output;
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

}  // namespace
}  // namespace asperity
