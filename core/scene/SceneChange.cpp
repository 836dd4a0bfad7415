#include "core/scene/SceneChange.h"

namespace asperity {

namespace {

bool haveSameSurface(SampleDescription a, const SampleDescription& b) {
    a.material = b.material;
    return a == b;
}

bool haveSameMaps(const SceneDescription& a, const SceneDescription& b) {
    return a.sample.material.maps == b.sample.material.maps &&
           a.truth.material.maps == b.truth.material.maps;
}

}  // namespace

SceneChange changeBetween(const SceneDescription& from, const SceneDescription& to) {
    if (from == to) {
        return SceneChange::None;
    }
    if (!haveSameSurface(from.sample, to.sample) || !haveSameMaps(from, to)) {
        return SceneChange::Surface;
    }
    SceneDescription shown = from;
    adoptShown(shown, to);
    // The one deviation that the tick reads.
    const bool isSameEstimate =
        from.uncertainty.normalDeviation() == to.uncertainty.normalDeviation();
    return shown == to && isSameEstimate ? SceneChange::Shown : SceneChange::Model;
}

void adoptShown(SceneDescription& scene, const SceneDescription& from) {
    scene.setpoint = from.setpoint;
    scene.zoomHalfWidth = from.zoomHalfWidth;
    scene.uncertainty = from.uncertainty;
    scene.markers = from.markers;
    scene.settings = from.settings;
}

}  // namespace asperity
