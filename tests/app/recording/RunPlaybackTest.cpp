#include "app/recording/RunPlayback.h"

#include "app/loading/SceneLoader.h"
#include "app/recording/Replay.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/haptics/SetpointApproach.h"
#include "tests/support/CanceledAfter.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// A recorded approach of 2.3 s, and what its ticks gave.
class RunPlaybackTest : public ::testing::Test {
protected:
    RunPlaybackTest() {
        const Scene& scene = loaded.scene;
        const PlannedApproach plan = planApproach(scene, {.duration = 2.0});
        ApproachDevice device(plan, scene.settings.positionGain);
        runVirtually(scene, device, *instrumentOf(scene), 2301, [this](const TickSample& sample) {
            expected.push_back(sample);
            run.samples.push_back({sample.time, sample.input, {}});
        });
    }

    static RunInputs inputsOf(const RecordedRun& run) {
        RunInputs inputs(run.memory);
        std::ranges::for_each(run.samples,
                              [&inputs](const TickSample& sample) { inputs.add(sample); });
        return inputs;
    }

    const LoadedScene loaded = loadScene(test::shippedScene("polystyrene"), {});
    RecordedRun run{.memory = {}, .samples = {}, .log = CsvTable("a\n", "log")};
    std::vector<TickSample> expected;
};

void expectSameBits(const TickSample& one, const TickSample& other) {
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.output.model.tip, other.output.model.tip);
    EXPECT_EQ(one.output.estimate.force, other.output.estimate.force);
    EXPECT_EQ(one.output.estimate.covariance, other.output.estimate.covariance);
    EXPECT_EQ(one.output.model.contact.branch, other.output.model.contact.branch);
    EXPECT_EQ(one.output.flags.bits(), other.output.flags.bits());
    EXPECT_EQ(one.input.settings, other.input.settings);
}

TEST_F(RunPlaybackTest, GivesEachTickInAnyOrderToTheBit) {
    RunPlayback playback(loaded.scene, inputsOf(run));
    ASSERT_EQ(playback.size(), expected.size());
    for (const std::size_t tick :
         {2300U, 0U, 1U, 2U, 499U, 500U, 501U, 500U, 1999U, 1000U, 999U, 2300U, 1250U, 1250U, 0U}) {
        expectSameBits(playback.at(tick), expected[tick]);
    }
}

TEST_F(RunPlaybackTest, GoesOnWithTheSettingsOfEachTick) {
    for (std::size_t tick = 700; tick < run.samples.size(); ++tick) {
        run.samples[tick].input.settings.forceGain *= 0.5;
    }
    RunPlayback playback(loaded.scene, inputsOf(run));
    std::vector<Vector3> forces;
    replayTicks(loaded.scene, run, [&forces](const TickSample& sample) {
        forces.push_back(sample.output.deviceForce);
    });
    for (const std::size_t tick : {2000U, 699U, 700U, 701U}) {
        EXPECT_EQ(playback.at(tick).output.deviceForce, forces[tick]) << tick;
        EXPECT_EQ(playback.at(tick).input.settings, run.samples[tick].input.settings) << tick;
    }
}

TEST_F(RunPlaybackTest, FindsTheTickOfATime) {
    const RunPlayback playback(loaded.scene, inputsOf(run));
    EXPECT_EQ(playback.tickAt(-1.0), 0U);
    EXPECT_EQ(playback.tickAt(0.0), 0U);
    EXPECT_EQ(playback.tickAt(playback.time(7)), 7U);
    EXPECT_EQ(playback.tickAt(std::nextafter(playback.time(7), 0.0)), 7U);
    EXPECT_EQ(playback.tickAt(playback.time(7) - 1e-6), 6U);
    EXPECT_EQ(playback.tickAt(100.0), 2300U);
}

TEST_F(RunPlaybackTest, TimesCountFromItsFirstTickWheneverTheLoopBegan) {
    const RunPlayback early(loaded.scene, inputsOf(run));
    for (TickSample& sample : run.samples) {
        sample.time += 1234.5;
    }
    RunPlayback late(loaded.scene, inputsOf(run));
    EXPECT_EQ(late.firstTime(), 0.0);
    EXPECT_NEAR(late.lastTime(), early.lastTime(), 1e-9);
    EXPECT_NEAR(late.at(700).time, early.time(700), 1e-9);
    EXPECT_EQ(late.at(700).output.model.tip, expected[700].output.model.tip);
    EXPECT_EQ(late.tickAt(early.time(700)), 700U);
}

TEST_F(RunPlaybackTest, PlaysTheBlackBoxOfARunWhoseKnobsWereTurned) {
    BlackBox box(loaded.scene.timeStep());
    TickMemory memory;
    ClosestPointTracker tracker;
    Snapshot latest;
    double jump = -1.0;
    for (TickSample sample : run.samples) {
        sample.input.settings.forceGain *= 0.5;
        sample.output = tick(loaded.scene, sample.input, memory, tracker);
        const bool jumps = !box.samples().empty() && sample.output.model.contact.branch !=
                                                         latest.sample.output.model.contact.branch;
        latest = {.sample = sample, .memory = memory, .statistics = {}, .trueTip = std::nullopt};
        box.take(sample);
        box.mark(latest);
        jump = jumps ? sample.time : jump;
    }
    RunPlayback playback(loaded.scene, box);
    ASSERT_EQ(playback.size(), box.samples().size());
    for (const std::size_t tick : {900U, 3U}) {
        EXPECT_EQ(playback.at(tick).output.deviceForce, box.samples()[tick].output.deviceForce);
    }
    ASSERT_TRUE(lastJump(box));
    EXPECT_EQ(box.samples()[*lastJump(box)].time, jump);
}

TEST_F(RunPlaybackTest, PlaysUntilItIsStoppedOrCanceled) {
    RunPlayback playback(loaded.scene, inputsOf(run));
    std::size_t ticks = 0;
    playback.play(2000, [&ticks](const TickSample&) { return ++ticks < 10; });
    EXPECT_EQ(ticks, 10U);
    test::CanceledAfter progress(1);
    EXPECT_THROW(playback.play(
                     0, [](const TickSample&) { return true; }, &progress),
                 Canceled);
}

/// A run of more pieces than one, whole and cut off.
TEST_F(RunPlaybackTest, ReadsAsManyTicksAsTheWholeRun) {
    const test::ScratchFolder scratch;
    const auto folder = scratch.path() / "run";
    std::filesystem::create_directory(folder);
    std::optional<RunRecorder> recorder(std::in_place, folder);
    constexpr std::size_t kTicks = 45'000;
    for (std::size_t tick = 0; tick < kTicks; ++tick) {
        TickSample sample = expected[tick % expected.size()];
        sample.time = 1e-3 * static_cast<double>(tick);
        recorder->take(sample);
    }
    recorder->close();
    (void)scratch.write("run/summary.json", R"({"input": {"sha256": "abc"}})");
    EXPECT_EQ(readRunInputs(folder).state, RunState::Recording);
    EXPECT_EQ(readRunInputs(folder).inputs.size(), kTicks);
    recorder.reset();
    const RunOnDisk whole = readRunInputs(folder);
    const RecordedRun before = readRun(folder);
    EXPECT_EQ(whole.scan.sha256, "abc");
    ASSERT_EQ(whole.inputs.size(), kTicks);
    for (const std::size_t tick : {0U, 19'999U, 20'000U, 20'001U, 44'999U}) {
        EXPECT_EQ(whole.inputs.time(tick), before.samples[tick].time);
        EXPECT_EQ(whole.inputs.input(tick).device.position,
                  before.samples[tick].input.device.position);
        EXPECT_EQ(whole.inputs.input(tick).measurement.signals.bending,
                  before.samples[tick].input.measurement.signals.bending);
    }
    std::ofstream(folder / run_files::kInput, std::ios::app) << "1,2,nonsense";
    try {
        (void)readRunInputs(folder);
        ADD_FAILURE();
    } catch (const InputError& error) {
        std::string told;
        try {
            (void)readRun(folder);
        } catch (const InputError& same) {
            told = same.what();
        }
        EXPECT_EQ(error.what(), told);  // with the line of the file
    }
}

TEST_F(RunPlaybackTest, RefusesARunWithoutTicksAndOneOfAnotherScene) {
    RecordedRun none = run;
    none.samples.clear();
    EXPECT_THROW(RunPlayback(loaded.scene, inputsOf(none)), Error);
    RecordedRun other = run;
    other.samples.front().input.settings.positionGain *= 2.0;
    EXPECT_THROW(RunPlayback(loaded.scene, inputsOf(other)), Error);
}

}  // namespace
}  // namespace asperity
