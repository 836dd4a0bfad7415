#pragma once

#include "core/surface/foot/SurfaceFoot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

/// Which feet a search is for: those no farther than `farthest`, nor farther than the nearest by
/// more than `behindNearest`.
struct FootReach {
    double farthest = std::numeric_limits<double>::infinity();  ///< [m]
    double behindNearest = 0.0;                                 ///< [m]

    /// How far a foot may lie to matter [m].
    [[nodiscard]] double limit(const SurfaceFoot& nearest) const noexcept {
        return limit(std::abs(nearest.distance));
    }
    /// @param nearest distance of the nearest foot, at most [m]
    [[nodiscard]] double limit(double nearest) const noexcept {
        return std::min(farthest, nearest + behindNearest);
    }
};

}  // namespace asperity
