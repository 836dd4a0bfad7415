#pragma once

#include "core/fidelity/RequiredTerms.h"
#include "core/scene/SceneDescription.h"

#include <string>
#include <vector>

namespace asperity::test {

/// A scene whose stated error is compared with the true one.
struct StatedErrorScene {
    std::string name;
    SceneDescription description;
};

/// Spheres, a cylinder, tilted planes, films, friction: what the fit leaves out, and what the scene
/// itself leaves out by about 1, 5 and 20 %; docs/tradeoff.md lists them.
[[nodiscard]] std::vector<StatedErrorScene> statedErrorScenes();

/// The error of a fitted scene's model against runs with all terms, at positions and along paths
/// that the fit did not look at, from the curves of force maps; with each term that the law of the
/// full model has no room for, as squares.
[[nodiscard]] QuantityErrors trueErrors(Scene& scene, const RequiredTerms& needs);

}  // namespace asperity::test
