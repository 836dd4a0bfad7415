#include "app/program/LoadedScene.h"

#include "core/probe/SimulatedAfm.h"
#include "core/scene/SceneTruth.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <iterator>

namespace asperity {

std::vector<std::string> notesOn(const LoadedScene& loaded) {
    std::vector<std::string> notes = loaded.notes;
    std::ranges::move(forceNotes(loaded.scene, loaded.needs), std::back_inserter(notes));
    return notes;
}

std::unique_ptr<AfmController> instrumentOf(const Scene& scene) {
    return std::make_unique<SimulatedAfm>(scene.trueSurface(), truthOf(scene));
}

}  // namespace asperity
