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
    return {.loaded = std::move(loaded), .run = std::move(run)};
}

}  // namespace asperity
