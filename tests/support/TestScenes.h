#pragma once

#include "core/scene/SceneDescription.h"
#include "core/surface/HeightMap.h"

namespace asperity {
struct Scene;
}  // namespace asperity

namespace asperity::test {

/// A level map of 64 x 64 pixels of 2 nm.
[[nodiscard]] HeightMap flatMap();

/// A plane that rises by `slope` along world x, same size as flatMap().
[[nodiscard]] HeightMap slopedMap(double slope);

/// Soft hills of 6 nm on 60 nm, same size as flatMap().
[[nodiscard]] HeightMap hillyMap();

/// Ridges along y of this height above and below 0, 60 nm apart, the first crest at x = 15 nm, the
/// first groove at x = 45 nm; same size as flatMap().
[[nodiscard]] HeightMap ridgedMap(double height);

/// The default scene (polystyrene, 15 nm tip, 14 N/m) without smoothing or leveling.
[[nodiscard]] SceneDescription plainScene();

}  // namespace asperity::test
