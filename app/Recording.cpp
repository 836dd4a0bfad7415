#include "app/Recording.h"

#include "app/RunSummary.h"
#include "core/io/SceneFile.h"
#include "core/io/SceneSettings.h"
#include "core/io/TickMemoryFile.h"
#include "core/scene/ModelTerm.h"

#include <utility>

namespace asperity {

namespace {

/// Made before the tables that go into it.
std::filesystem::path made(std::filesystem::path folder) {
    makeOutputFolder(folder);
    return folder;
}

}  // namespace

Recording::Recording(std::filesystem::path folder, const LoadedScene& loaded,
                     const TickMemory& memory, double delay)
    : folder_(made(std::move(folder)))
    , loaded_(loaded)
    , recorder_(folder_)
    , energy_(folder_ / run_files::kEnergy, loaded.scene.timeStep(), delay) {
    writeTickMemory(folder_ / run_files::kMemory, memory);
}

void Recording::take(const TickSample& sample) {
    if (ticks() == 0) {
        start_ = sample.input.settings;
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

void Recording::finish() {
    recorder_.close();
    energy_.close();
    writeTextFile(
        folder_ / run_files::kScene,
        sceneText(withSettings(settled(loaded_.scene.description, loaded_.scene.model), start_)));
    writeTextFile(folder_ / run_files::kSummary, runSummary(loaded_, events_.events()));
}

}  // namespace asperity
