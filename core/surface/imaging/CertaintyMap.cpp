#include "core/surface/imaging/CertaintyMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity {

namespace {

/// The pixel of a line of `count` that holds `place`, or the nearest one. 0 for what is no number.
int pixelAt(double place, double pitch, int count) {
    const double pixel = place / pitch;
    if (!std::isgreater(pixel, 0.0)) {
        return 0;
    }
    return static_cast<int>(std::min(pixel, count - 1.0));
}

}  // namespace

bool CertaintyMap::isUncertain(double x, double y) const noexcept {
    if (!isKnown()) {
        return false;
    }
    const int row = rows_ - 1 - pixelAt(y, pitchY_, rows_);
    return !certain_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(pixelAt(x, pitchX_, columns_))];
}

double CertaintyMap::certainShare() const noexcept {
    const auto certain = std::ranges::count(certain_, true);
    return isKnown() ? static_cast<double>(certain) / static_cast<double>(certain_.size()) : 0.0;
}

}  // namespace asperity
