#pragma once

#include "core/surface/closest/ClosestPoint.h"

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <limits>
#include <span>

namespace asperity {

/// More minima of the distance than these are not kept apart: several may stand so near to each
/// other that they are one closest point.
inline constexpr std::size_t kMaxMinima = 12;

/// Minima of the distance of one query, the nearest first; where there are more than kMaxMinima,
/// the nearest of them.
class ClosestPointList {
public:
    /// Takes a closest point up unless it stands nearer than `sameWithin` [m] to one that does
    /// already.
    void add(const ClosestPoint& closest, double sameWithin) noexcept;

    [[nodiscard]] std::span<const ClosestPoint> all() const noexcept {
        return {points_.data(), points_.size()};
    }

    /// Whether a closest point no farther than this had no room [m].
    [[nodiscard]] bool hasLeftOut(double distance) const noexcept {
        return leftOutFrom_ <= distance;
    }

private:
    boost::container::static_vector<ClosestPoint, kMaxMinima> points_;
    double leftOutFrom_ = std::numeric_limits<double>::infinity();  ///< the nearest [m]
};

}  // namespace asperity
