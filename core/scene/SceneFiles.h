#pragma once

#include "core/scene/SceneDescription.h"

namespace asperity {

/// Calls visit(file) with the path of each file that a scene is read from: the scan and the maps of
/// its materials. @param scene SceneDescription, const or not
template <class Scene, class Visit>
void forEachFile(Scene& scene, const Visit& visit) {
    if (!scene.sample.shape) {
        visit(scene.sample.file);
    }
    for (auto* maps : {&scene.sample.material.maps, &scene.truth.material.maps}) {
        forEachSource(*maps, [&visit](auto& source) { visit(source.file); });
    }
}

/// The scene as its user writes it: it may be opened with maps that have changed since.
[[nodiscard]] inline SceneDescription withoutHashes(SceneDescription scene) {
    for (MaterialSources* maps : {&scene.sample.material.maps, &scene.truth.material.maps}) {
        forEachSource(*maps, [](MapSource& source) { source.sha256.clear(); });
    }
    return scene;
}

}  // namespace asperity
