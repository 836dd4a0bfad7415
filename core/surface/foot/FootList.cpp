#include "core/surface/foot/FootList.h"

#include <algorithm>
#include <cmath>

namespace asperity {

void FootList::add(const SurfaceFoot& foot, double sameWithin) noexcept {
    const bool isKnown = std::ranges::any_of(all(), [&](const SurfaceFoot& known) {
        return (known.point - foot.point).norm() <= sameWithin;
    });
    if (isKnown) {
        return;
    }
    const auto place = std::ranges::find_if(feet_, [&](const SurfaceFoot& known) {
        return std::abs(foot.distance) < std::abs(known.distance);
    });
    if (feet_.size() < kMaxMinima) {
        feet_.insert(place, foot);
        return;
    }
    hasLeftOut_ = true;
    if (place != feet_.end()) {
        std::move_backward(place, feet_.end() - 1, feet_.end());
        *place = foot;
    }
}

void FootList::keepNearest(std::size_t count) noexcept {
    while (feet_.size() > count) {
        feet_.pop_back();
    }
}

}  // namespace asperity
