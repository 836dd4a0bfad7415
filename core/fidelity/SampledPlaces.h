#pragma once

#include "core/Vector.h"

#include <vector>

namespace asperity {

struct Scene;

/// Positions of the base, world x and y [m], at which models of a scene are compared: the highest
/// feature; the positions where the tip touches the sample with the smallest, the largest and the
/// quartiles of effective radius; with the steepest slopes along x and along y, both ways; of a
/// sample of several materials the softest, the stiffest, the least and the most adhesive. Where
/// the tip does not fit, also above the sharpest hollow. Positions that look alike count once; a
/// part of the sample that the tip cannot reach does not count, nor one outside the scan or without
/// data. The same for every model of the scene.
[[nodiscard]] std::vector<Vector2> sampledPlaces(const Scene& scene);

}  // namespace asperity
