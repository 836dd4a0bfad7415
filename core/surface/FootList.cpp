#include "core/surface/FootList.h"

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
    std::size_t place = count_;
    while (place > 0 && std::abs(foot.distance) < std::abs(feet_[place - 1].distance)) {
        --place;
    }
    if (place == feet_.size()) {
        return;
    }
    count_ = std::min(count_ + 1, feet_.size());
    std::move_backward(feet_.begin() + static_cast<std::ptrdiff_t>(place),
                       feet_.begin() + static_cast<std::ptrdiff_t>(count_ - 1),
                       feet_.begin() + static_cast<std::ptrdiff_t>(count_));
    feet_[place] = foot;
}

}  // namespace asperity
