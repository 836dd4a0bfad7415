#include "core/surface/closest/ClosestPointList.h"

#include <algorithm>
#include <cmath>

namespace asperity {

void ClosestPointList::add(const ClosestPoint& closest, double sameWithin) noexcept {
    const bool isKnown = std::ranges::any_of(all(), [&](const ClosestPoint& known) {
        return (known.point - closest.point).norm() <= sameWithin;
    });
    if (isKnown) {
        return;
    }
    const auto place = std::ranges::find_if(points_, [&](const ClosestPoint& known) {
        return std::abs(closest.distance) < std::abs(known.distance);
    });
    if (points_.size() < kMaxMinima) {
        points_.insert(place, closest);
        return;
    }
    hasLeftOut_ = true;
    if (place != points_.end()) {
        std::move_backward(place, points_.end() - 1, points_.end());
        *place = closest;
    }
}

void ClosestPointList::keepNearest(std::size_t count) noexcept {
    while (points_.size() > count) {
        points_.pop_back();
    }
}

}  // namespace asperity
