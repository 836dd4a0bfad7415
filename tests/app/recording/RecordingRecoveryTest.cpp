#include "app/recording/RecordingRecovery.h"

#include "app/loading/SceneLoader.h"
#include "app/recording/RecordedRun.h"
#include "app/recording/Recording.h"
#include "core/Error.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// A recording that its process never finished.
class CutOff : public ::testing::Test {
protected:
    void record(long ticks) {
        recording = std::make_unique<Recording>(RecordingTarget{run}, loaded, memory, 0.0);
        TickInput input;
        input.timeStep = loaded.scene.timeStep();
        input.settings = loaded.scene.settings;
        input.settings.forceGain = 3.0;  // not as in the scene
        input.device.connected = true;
        for (long i = 0; i < ticks; ++i) {
            const double time = static_cast<double>(i) * input.timeStep;
            input.device.position = Vector3(2e-7 + 1e-9 * time, 2e-7, 1e-8);
            recording->take({time, input, tick(loaded.scene, input, memory)});
        }
        recording->flush();
    }
    void cutOff(long ticks) {
        record(ticks);
        recording.reset();
    }
    void append(const char* table, const std::string& text) const {
        std::ofstream(run / table, std::ios::app | std::ios::binary) << text;
    }
    /// Removes bytes from the end of a table.
    void shorten(const char* table, std::uintmax_t bytes) const {
        fs::resize_file(run / table, fs::file_size(run / table) - bytes);
    }
    /// @return what it said
    std::string replayed(const std::string& ticks) const {
        const auto again =
            test::runProgram("replay " + run.string() + " --out " + folder.file("again").string());
        EXPECT_EQ(again.exitCode, 0) << again.output;
        EXPECT_NE(again.output.find("bit-identical: " + ticks + " ticks"), std::string::npos)
            << again.output;
        return again.output;
    }

    test::ScratchFolder folder;
    LoadedScene loaded = loadScene(test::shippedScene("polystyrene"), {});
    TickMemory memory;
    fs::path run = folder.path() / "run";
    std::unique_ptr<Recording> recording;
};

TEST_F(CutOff, ReplaysUpToItsLastWholeTickAndSaysSo) {
    cutOff(200);
    shorten(run_files::kInput, 1);                     // in the middle of the last line
    append(run_files::kLog, "0.2,1e-9,half of a li");  // and one line more
    EXPECT_NE(replayed("199").find("cut off"), std::string::npos);
}

/// After a power cut a file may be there with nothing in it.
TEST_F(CutOff, SaysSoWhereATableIsEmpty) {
    cutOff(200);
    fs::resize_file(run / run_files::kLog, 0);
    const auto replay =
        test::runProgram("replay " + run.string() + " --out " + folder.file("again").string());
    EXPECT_EQ(replay.exitCode, 3) << replay.output;
    EXPECT_NE(replay.output.find("cut off before its first tick"), std::string::npos)
        << replay.output;
}

TEST_F(CutOff, IsEndedAtTheLastTickThatAllTablesHold) {
    cutOff(200);
    shorten(run_files::kLog, 5000);
    append(run_files::kInput, std::string(4096, '\0'));  // as after a power cut
    const auto recovered = recoverRecordings(folder.path());
    ASSERT_EQ(recovered.size(), 1U);
    EXPECT_EQ(recovered[0].folder, run);
    EXPECT_EQ(recovered[0].problem, "");
    const CsvTable log = readCsv(run / run_files::kLog);
    ASSERT_GT(log.rows(), 150U);
    EXPECT_LT(log.rows(), 200U);
    EXPECT_EQ(readTickInputs(run / run_files::kInput).size(), log.rows());
    EXPECT_NEAR(recovered[0].duration, static_cast<double>(log.rows() - 1) * 1e-3, 1e-9);
    EXPECT_EQ(stateOf(run), RunState::Recovered);
    EXPECT_NE(replayed(std::to_string(log.rows())).find("cut off"), std::string::npos);
    EXPECT_TRUE(recoverRecordings(folder.path()).empty()) << "once";
}

/// A reader may be corrected between recording and replay.
TEST_F(CutOff, SaysWithWhichSizeItsScanWasRead) {
    cutOff(3);
    const BSplineSurface& surface = loaded.scene.surface;
    const Vector2 size(surface.sizeX(), surface.sizeY());
    EXPECT_EQ(scanRecord(run).size, size);
    ASSERT_EQ(recoverRecordings(folder.path()).size(), 1U);
    EXPECT_EQ(scanRecord(run).size, size);
}

TEST_F(CutOff, BeforeItsFirstTickItIsARecordingOfNothing) {
    cutOff(0);
    EXPECT_NE(replayed("0").find("before its first tick"), std::string::npos);
    const auto recovered = recoverRecordings(folder.path());
    ASSERT_EQ(recovered.size(), 1U);
    EXPECT_EQ(recovered[0].problem, "");
    EXPECT_EQ(recovered[0].duration, 0.0);
    EXPECT_NE(replayed("0").find("before its first tick"), std::string::npos);
}

TEST_F(CutOff, IsNotTouchedWhereItGoesOnOrIsDamaged) {
    record(100);
    const std::string input = test::contentOf(run / run_files::kInput);
    EXPECT_TRUE(recoverRecordings(folder.path()).empty());
    EXPECT_NE(replayed("100").find("still being written"), std::string::npos);
    recording.reset();
    fs::rename(run / run_files::kLog, run / "log");
    const auto recovered = recoverRecordings(folder.path());
    ASSERT_EQ(recovered.size(), 1U);
    EXPECT_NE(recovered[0].problem.find(run_files::kLog), std::string::npos);
    EXPECT_EQ(test::contentOf(run / run_files::kInput), input);
    EXPECT_EQ(stateOf(run), RunState::Unfinished);
}

TEST_F(CutOff, WholeRunsAndOtherFoldersStayAsTheyAre) {
    record(100);
    recording->finish();
    recording.reset();
    fs::create_directory(folder.file("notes"));
    fs::create_directory_symlink("run", folder.file("link"));
    EXPECT_TRUE(recoverRecordings(folder.path()).empty());
    EXPECT_TRUE(recoverRecordings(folder.file("nowhere")).empty());
    EXPECT_EQ(replayed("100").find("cut off"), std::string::npos);
}

}  // namespace
}  // namespace asperity
