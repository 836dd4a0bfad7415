#include "core/surface/closest/ClosestPointList.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

/// The nearest first, and of those as near a certain one, in whatever order they are found.
std::array<double, 3> orderOf(const ClosestPoint& closest) {
    return {std::abs(closest.distance), closest.point.x(), closest.point.y()};
}

}  // namespace

void ClosestPointList::add(const ClosestPoint& closest, double sameWithin) noexcept {
    const bool isKnown = std::ranges::any_of(all(), [&](const ClosestPoint& known) {
        return (known.point - closest.point).norm() <= sameWithin;
    });
    if (isKnown) {
        return;
    }
    const auto found = std::ranges::find_if(
        points_, [&](const ClosestPoint& known) { return orderOf(closest) < orderOf(known); });
    if (points_.size() < kMaxMinima) {
        points_.insert(found, closest);
        return;
    }
    const ClosestPoint& leftOut = found == points_.end() ? closest : points_.back();
    leftOutFrom_ = std::min(leftOutFrom_, std::abs(leftOut.distance));
    if (found != points_.end()) {
        std::move_backward(found, points_.end() - 1, points_.end());
        *found = closest;
    }
}

}  // namespace asperity
