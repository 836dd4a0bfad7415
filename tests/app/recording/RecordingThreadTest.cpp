#include "app/recording/RecordedRun.h"
#include "app/recording/RunRecording.h"
#include "core/Error.h"
#include "tests/app/recording/HillyScene.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace asperity {
namespace {

class OnItsOwnThread : public ::testing::Test {
protected:
    /// Ticks that hold nothing but their time and position.
    TickSample next() {
        TickSample sample;
        sample.time = static_cast<double>(count++) * loaded.scene.timeStep();
        sample.input.timeStep = loaded.scene.timeStep();
        sample.input.settings = loaded.scene.settings;
        sample.input.device.position.x() = 1e-9 * sample.time;
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
            ASSERT_EQ(sample.input.device.position.x(), 1e-9 * sample.time);
        }
    }

    test::ScratchFolder folder;
    LoadedScene loaded = test::hillyScene();
    std::filesystem::path run = folder.path() / "run";
    long count = 0;
};

TEST_F(OnItsOwnThread, EveryTickIsThereWhenItIsFinished) {
    RecordingThread recording({run}, loaded, {}, 0.0);
    give(recording, 10'007);
    recording.finish();
    EXPECT_EQ(recording.end(), RecordingEnd::None);
    EXPECT_EQ(recording.ticks(), 10'007);
    EXPECT_GT(recording.timePerTick(), 0.0);
    expectHolds(10'007);
}

TEST_F(OnItsOwnThread, ARecordingOfNothingIsARecording) {
    RecordingThread recording({run}, loaded, {}, 0.0);
    recording.finish();
    expectHolds(0);
}

TEST_F(OnItsOwnThread, EndsWhereTicksAreLost) {
    RecordingThread recording({run}, loaded, {}, 0.0);
    give(recording, 1500);
    count += 20;
    give(recording, 1500);
    recording.finish();
    EXPECT_EQ(recording.end(), RecordingEnd::TicksLost);
    expectHolds(1500);
}

// A loop without any pause makes ticks a hundred times as fast as they can be written.
TEST_F(OnItsOwnThread, ADiskThatDoesNotFollowEndsItInGoodOrder) {
    RecordingThread recording({run}, loaded, {}, 0.0);
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

TEST_F(OnItsOwnThread, EndsAtOnceWhereTheDiskIsFullAndKeepsWhatWasWritten) {
    RecordingThread recording({run}, loaded, {}, 0.0);
    const test::FileSizeLimit full(300'000);
    while (recording.end() == RecordingEnd::None && count < 50'000) {
        give(recording, 100);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(recording.end(), RecordingEnd::Failed);
    try {
        recording.finish();
        FAIL() << "not all was written";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("File too large"), std::string::npos);
    }
    const RecordedRun kept = readRun(run);
    EXPECT_GT(kept.samples.size(), 200U);
    EXPECT_LE(kept.samples.size(), kept.log.rows());
    for (std::size_t i = 0; i < kept.samples.size(); ++i) {
        ASSERT_EQ(kept.samples[i].time, static_cast<double>(i) * loaded.scene.timeStep());
    }
}

TEST_F(OnItsOwnThread, HoldsOlderTicksWhileItGoesOn) {
    RecordingThread recording({run}, loaded, {}, 0.0);
    give(recording, 1000);
    EXPECT_EQ(stateOf(run), RunState::Recording);
    std::size_t held = 0;
    for (int i = 0; i < 100 && held < 900; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        held = readRun(run).samples.size();
    }
    EXPECT_GE(held, 900U);
    recording.finish();
    EXPECT_EQ(stateOf(run), RunState::Recording) << "until its files are closed";
}

TEST_F(OnItsOwnThread, KeepsWhatWasHandedOverWhereItIsGivenUp) {
    {
        RecordingThread recording({run}, loaded, {}, 0.0);
        give(recording, 1000);
    }
    EXPECT_EQ(stateOf(run), RunState::Unfinished);
    EXPECT_GE(readRun(run).samples.size(), 890U);
    EXPECT_FALSE(std::filesystem::exists(run / run_files::kSummary));
}

TEST_F(OnItsOwnThread, WritesOverNoRun) {
    std::filesystem::create_directory(run);
    std::ofstream(run / run_files::kEnergy) << "earlier";
    EXPECT_THROW(RecordingThread({run}, loaded, {}, 0.0), Error);
    EXPECT_EQ(test::contentOf(run / run_files::kEnergy), "earlier");
    RecordingThread recording({.folder = run, .replace = true}, loaded, {}, 0.0);
    EXPECT_NE(test::contentOf(run / run_files::kEnergy), "earlier");
    EXPECT_THROW(RecordingThread({.folder = run, .replace = true}, loaded, {}, 0.0), Error)
        << "it goes on";
    recording.finish();
    EXPECT_TRUE(std::filesystem::exists(run / run_files::kManifest));
}

TEST_F(OnItsOwnThread, BringsBackWhatItReplacesWhereItCannotBegin) {
    std::filesystem::create_directory(run);
    std::ofstream(run / run_files::kEnergy) << "earlier";
    {
        const test::FileSizeLimit full(100);
        EXPECT_THROW(RecordingThread({.folder = run, .replace = true}, loaded, {}, 0.0), Error);
    }
    EXPECT_EQ(test::contentOf(run / run_files::kEnergy), "earlier");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(run), {}), 1);
    const std::filesystem::path fresh = folder.path() / "fresh";
    {
        const test::FileSizeLimit full(100);
        EXPECT_THROW(RecordingThread({fresh}, loaded, {}, 0.0), Error);
    }
    EXPECT_FALSE(std::filesystem::exists(fresh)) << "a full disk leaves no half of a recording";
}

}  // namespace
}  // namespace asperity
