#pragma once

#include "bench/scaling/ScalingSweep.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Extent of the measurement.
struct ScalingEffort {
    std::vector<int> tiles{1, 2, 4, 8, 16};  ///< along each side of the map, of 512 pixels each
    std::size_t steps = 20000;               ///< of each slide, 0.1 nm long
};

/// Smoothing and fit of a whole map, and the same slide over it: its certified closest points, and
/// these with force and decoupling.
[[nodiscard]] ScalingSweep sweepPixels(const ScalingEffort& effort);

/// Certified closest points of tips of 1 to 200 pixels that slide over one map.
[[nodiscard]] ScalingSweep sweepTipRadius(const ScalingEffort& effort);

/// Certified closest points on self-affine roughness of 1 to 10 nm.
[[nodiscard]] ScalingSweep sweepRoughness(const ScalingEffort& effort);

}  // namespace asperity
