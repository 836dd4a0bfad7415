#include "app/recording/Replay.h"
#include "app/recording/RunRecording.h"
#include "app/runs/LiveRun.h"
#include "app/runs/RunFolder.h"
#include "core/haptics/DevicePath.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "tests/app/recording/HillyScene.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/SlowAfm.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace asperity {
namespace {

/// The loop, its recording and the replay with an instrument that answers every 20 ms and is lost
/// in the end.
TEST(SlowInstrumentRun, IsRecordedAndReplaysToTheSameBits) {
    const test::ScratchFolder folder;
    LoadedScene loaded = test::hillyScene();
    const DevicePath path = slidePath(loaded.scene, {.duration = 1.5});
    test::SlowAfm* instrument = nullptr;
    LiveRun run(std::move(loaded), path.front().position, [&](const Scene& scene) {
        auto slow = std::make_unique<test::SlowAfm>(scene.trueSurface(), truthOf(scene), 20e-3);
        instrument = slow.get();
        return slow;
    });
    run.takeDevice(
        [&] { return std::make_unique<ScriptedDevice>(path, run.settings().positionGain); });
    RecordingThread recording({folder.path() / "run"}, run.loaded(), run.loop().memory(), 0.0);
    long stale = 0;
    long lost = 0;
    const auto fetchFor = [&](double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            run.fetch([&](const TickSample& sample) {
                recording.take(sample);
                stale += sample.output.flags.has(Validity::StaleSignals) ? 1 : 0;
                lost += sample.output.fault == Fault::InstrumentLost ? 1 : 0;
            });
        }
    };
    run.loop().start();
    fetchFor(1.6);
    run.loop().stop();
    instrument->lost = true;  // while nobody asks it
    run.loop().start();
    fetchFor(0.2);
    run.loop().stop();
    run.fetch([&](const TickSample& sample) { recording.take(sample); });
    recording.finish();
    EXPECT_GT(stale, 0);
    EXPECT_GT(lost, 0);
    const RecordedRun recorded = readRun(folder.path() / "run");
    const Scene again =
        buildScene(readScene(folder.path() / "run" / run_files::kScene), test::hillyMap());
    std::filesystem::create_directory(folder.path() / "again");
    const CsvTable log = replay(again, recorded, folder.path() / "again");
    EXPECT_NO_THROW(requireSameLog(recorded, log));
    EXPECT_GT(log.rows(), 1000U);
}

}  // namespace
}  // namespace asperity
