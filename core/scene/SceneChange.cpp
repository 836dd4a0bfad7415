#include "core/scene/SceneChange.h"

namespace asperity {

namespace {

bool haveSameSurface(SampleDescription a, const SampleDescription& b) {
    a.material = b.material;
    return a == b;
}

}  // namespace

SceneChange changeBetween(const SceneDescription& from, const SceneDescription& to) {
    if (from == to) {
        return SceneChange::None;
    }
    if (!haveSameSurface(from.sample, to.sample)) {
        return SceneChange::Surface;
    }
    SceneDescription shown = from;
    adoptShown(shown, to);
    return shown == to ? SceneChange::Shown : SceneChange::Model;
}

void adoptShown(SceneDescription& scene, const SceneDescription& from) {
    scene.setpoint = from.setpoint;
    scene.zoomHalfWidth = from.zoomHalfWidth;
    scene.markers = from.markers;
    scene.settings = from.settings;
}

}  // namespace asperity
