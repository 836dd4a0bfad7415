#include "app/loading/RunWithScene.h"

#include "app/loading/SceneLoader.h"
#include "app/recording/Replay.h"
#include "app/runs/RunFolder.h"

#include <utility>

namespace asperity {

RunWithScene readRunWithScene(const std::filesystem::path& folder, Progress* progress) {
    RunOnDisk run = readRunInputs(folder);
    LoadedScene loaded = loadScene(folder / run_files::kScene, {}, progress);
    requireSameScan(loaded, folder);
    std::string note = sentenceOf(run.state);
    if (const std::string correction = correctionOfScan(loaded, folder); !correction.empty()) {
        note += (note.empty() ? "" : "; ") + correction;
    }
    return {.loaded = std::move(loaded), .run = std::move(run), .note = std::move(note)};
}

}  // namespace asperity
