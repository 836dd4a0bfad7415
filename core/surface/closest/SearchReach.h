#pragma once

#include "core/surface/closest/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

/// Which closest points a search is for: those no farther than `farthest`, nor farther than the
/// nearest, or than the surface of a sphere about the query, by more than `behindNearest`.
struct SearchReach {
    double farthest = std::numeric_limits<double>::infinity();  ///< [m]
    double behindNearest = 0.0;                                 ///< [m]
    double radius = 0.0;                                        ///< of that sphere [m]

    /// How far a closest point may lie to matter [m].
    [[nodiscard]] double limit(const ClosestPoint& nearest) const noexcept {
        return limit(std::abs(nearest.distance));
    }
    /// @param nearest distance of the closest point, at most [m]
    [[nodiscard]] double limit(double nearest) const noexcept {
        return std::min(farthest, std::max(nearest, radius) + behindNearest);
    }
};

}  // namespace asperity
