#pragma once

#include "core/scene/Scene.h"
#include "core/scene/TipValidity.h"

namespace asperity {

/// One side of a scene that a map is made of: what is believed, or what is simulated to be true.
/// The scene must outlive it.
class MapInstrument {
public:
    MapInstrument(const Scene& scene, bool truth)
        : scene_(scene)
        , truth_(truth)
        , surface_(truth ? scene.trueSurface() : scene.believedSurface()) {}

    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] const SampleSurface& surface() const noexcept { return surface_; }
    [[nodiscard]] const ProbeSystem& system() const noexcept {
        return truth_ ? scene_.truth : scene_.belief;
    }
    /// What the state does not hold for.
    [[nodiscard]] ValidityFlags validity(const TipState& state) const noexcept {
        const SceneDescription& description = scene_.description;
        return tipValidity(scene_, system(),
                           truth_ ? description.truth.material : description.sample.material,
                           state);
    }

private:
    const Scene& scene_;
    bool truth_;
    SampleSurface surface_;
};

}  // namespace asperity
