#include "app/RecordingThread.h"

#include "core/Error.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

class OnItsOwnThread : public ::testing::Test {
protected:
    /// Ticks that tell nothing but their time and place.
    TickSample next() {
        TickSample sample;
        sample.time = static_cast<double>(count++) * loaded.scene.timeStep();
        sample.input.timeStep = loaded.scene.timeStep();
        sample.input.settings = loaded.scene.settings;
        sample.input.hand.position.x() = 1e-9 * sample.time;
        return sample;
    }
    void give(RecordingThread& recording, long ticks) {
        for (long i = 0; i < ticks; ++i) {
            recording.take(next());
        }
    }
    /// The recorded ticks are the first ones that were given, bit by bit.
    void expectHolds(long ticks) const {
        const std::vector<TickSample> read = readTickInputs(run / run_files::kInput);
        ASSERT_EQ(static_cast<long>(read.size()), ticks);
        for (long i = 0; i < ticks; ++i) {
            const TickSample& sample = read[static_cast<std::size_t>(i)];
            ASSERT_EQ(sample.time, static_cast<double>(i) * loaded.scene.timeStep());
            ASSERT_EQ(sample.input.hand.position.x(), 1e-9 * sample.time);
        }
    }

    test::ScratchFolder folder;
    LoadedScene loaded = loadScene(test::shippedScene("polystyrene"), {});
    std::filesystem::path run = folder.path() / "run";
    long count = 0;
};

TEST_F(OnItsOwnThread, EveryTickIsThereWhenItIsFinished) {
    RecordingThread recording(run, loaded, {}, 0.0);
    give(recording, 10'007);
    recording.finish();
    EXPECT_EQ(recording.end(), RecordingEnd::None);
    EXPECT_EQ(recording.ticks(), 10'007);
    EXPECT_GT(recording.timePerTick(), 0.0);
    expectHolds(10'007);
}

TEST_F(OnItsOwnThread, ARecordingOfNothingIsARecording) {
    RecordingThread recording(run, loaded, {}, 0.0);
    recording.finish();
    expectHolds(0);
}

TEST_F(OnItsOwnThread, EndsWhereTicksAreLost) {
    RecordingThread recording(run, loaded, {}, 0.0);
    give(recording, 1500);
    count += 20;
    give(recording, 1500);
    recording.finish();
    EXPECT_EQ(recording.end(), RecordingEnd::TicksLost);
    expectHolds(1500);
}

// A loop without any pause makes ticks a hundred times as fast as they can be written.
TEST_F(OnItsOwnThread, ADiskThatDoesNotFollowEndsItInGoodOrder) {
    RecordingThread recording(run, loaded, {}, 0.0);
    while (recording.end() == RecordingEnd::None && count < 10'000'000) {
        give(recording, 1000);
    }
    EXPECT_EQ(recording.end(), RecordingEnd::DiskTooSlow);
    give(recording, 1000);
    recording.finish();
    EXPECT_EQ(recording.end(), RecordingEnd::DiskTooSlow);
    EXPECT_LT(recording.ticks(), count);
    expectHolds(recording.ticks());
}

TEST_F(OnItsOwnThread, SaysWhatCannotBeWritten) {
    RecordingThread recording(run, loaded, {}, 0.0);
    give(recording, 1000);
    std::filesystem::create_directory(run / run_files::kLog);
    try {
        recording.finish();
        FAIL() << "a table cannot take the place of a folder";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(run_files::kLog), std::string::npos);
    }
    EXPECT_EQ(recording.end(), RecordingEnd::Failed);
}

TEST_F(OnItsOwnThread, LeavesNoTablesWhereItIsGivenUp) {
    {
        RecordingThread recording(run, loaded, {}, 0.0);
        give(recording, 1000);
    }
    EXPECT_FALSE(std::filesystem::exists(run / run_files::kInput));
    EXPECT_FALSE(std::filesystem::exists(run / run_files::kSummary));
}

}  // namespace
}  // namespace asperity
