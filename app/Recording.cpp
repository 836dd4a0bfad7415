#include "app/Recording.h"

#include "app/RecordingManifest.h"
#include "app/RunSummary.h"
#include "core/GrowingFile.h"
#include "core/io/SceneFile.h"
#include "core/io/SceneSettings.h"
#include "core/io/TickMemoryFile.h"
#include "core/scene/ModelTerm.h"

#include <utility>

namespace asperity {

namespace {

/// Made before the tables that go into it.
std::filesystem::path made(std::filesystem::path folder) {
    requireNoRun(folder);
    makeOutputFolder(folder);
    return folder;
}

}  // namespace

// The manifest comes last: where it is, all is there that a replay takes.
Recording::Recording(std::filesystem::path folder, const LoadedScene& loaded,
                     const TickMemory& memory, double delay)
    : folder_(made(std::move(folder)))
    , loaded_(loaded)
    , recorder_(folder_)
    , energy_(folder_ / run_files::kEnergy, loaded.scene.timeStep(), delay) {
    writeTickMemory(folder_ / run_files::kMemory, memory);
    writeScene(loaded.scene.settings);
    writeManifest(folder_, {.sha256 = loaded.sha256});
}

void Recording::writeScene(const Settings& start) {
    start_ = start;
    writeTextFile(
        folder_ / run_files::kScene,
        sceneText(withSettings(settled(loaded_.scene.description, loaded_.scene.model), start)));
}

void Recording::take(const TickSample& sample) {
    if (ticks() == 0) {
        if (sample.input.settings != start_) {
            writeScene(sample.input.settings);
        }
    } else {
        const double gap = sample.time - lastTime_ - sample.input.timeStep;
        broken_ = broken_ || gap > 0.5 * loaded_.scene.timeStep();
    }
    if (!broken_) {
        recorder_.take(sample);
        events_.take(sample);
        energy_.take(sample);
        lastTime_ = sample.time;
    }
}

void Recording::flush() {
    recorder_.flush();
    energy_.flush();
}

void Recording::sync() {
    if (!std::exchange(startSynced_, true)) {
        for (const char* name :
             {run_files::kMemory, run_files::kScene, run_files::kManifest, "."}) {
            syncToDisk(folder_ / name);
        }
    }
    recorder_.sync();
    energy_.sync();
}

void Recording::finish() {
    flush();
    writeTextFile(folder_ / run_files::kSummary, runSummary(loaded_, events_.events()));
    syncToDisk(folder_ / run_files::kSummary);
    sync();
    writeManifest(folder_, {.sha256 = loaded_.sha256, .complete = true});
}

}  // namespace asperity
