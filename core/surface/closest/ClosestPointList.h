#pragma once

#include "core/surface/closest/ClosestPoint.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace asperity {

/// More minima of the distance than these are not kept apart: several may be so near to each
/// other that they are one closest point.
inline constexpr std::size_t kMaxMinima = 12;

/// Minima of the distance of one query, the nearest first; where there are more than kMaxMinima,
/// the nearest of them.
class ClosestPointList {
public:
    /// Takes a closest point up unless it lies nearer than `sameWithin` [m] to one that does
    /// already.
    void add(const ClosestPoint& closest, double sameWithin) noexcept;

    [[nodiscard]] std::span<const ClosestPoint> all() const noexcept {
        return {points_.data(), points_.size()};
    }

    /// Returns whether a closest point no farther than this was left out for lack of space [m].
    [[nodiscard]] bool hasLeftOut(double distance) const noexcept {
        return leftOutFrom_ <= distance;
    }

private:
    boost::container::static_vector<ClosestPoint, kMaxMinima> points_;
    double leftOutFrom_ = std::numeric_limits<double>::infinity();  ///< the nearest [m]
};

/// Closest points that a search is for: those no farther than `farthest`, nor farther than the
/// nearest, or than the surface of a sphere about the query, by more than `behindNearest`.
struct SearchReach {
    double farthest = std::numeric_limits<double>::infinity();  ///< [m]
    double behindNearest = 0.0;                                 ///< [m]
    double radius = 0.0;                                        ///< of that sphere [m]

    /// Distance beyond which a closest point does not matter [m].
    [[nodiscard]] double limit(const ClosestPoint& nearest) const noexcept {
        return limit(std::abs(nearest.distance));
    }
    /// @param nearest distance of the closest point, at most [m]
    [[nodiscard]] double limit(double nearest) const noexcept {
        return std::min(farthest, std::max(nearest, radius) + behindNearest);
    }
};

}  // namespace asperity
