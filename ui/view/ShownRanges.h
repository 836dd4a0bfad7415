#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace asperity {

/// What a picture has shown since its scene was set. Kept, it is what the scales have room for from
/// then on, so that they stay as they are through a film.
class ShownRanges {
public:
    void keep() { isKept_ = true; }
    [[nodiscard]] bool isKept() const { return isKept_; }

    /// @param heights lowest and highest that are shown now [m]
    /// @return those that there is to be room for
    std::array<double, 2> heights(const std::array<double, 2>& heights) {
        heights_ = {std::min(heights_[0], heights[0]), std::max(heights_[1], heights[1])};
        return isKept_ ? heights_ : heights;
    }
    /// The same of the largest displacement [m].
    double displacement(double largest) {
        displacement_ = std::max(displacement_, largest);
        return isKept_ ? displacement_ : largest;
    }

private:
    std::array<double, 2> heights_{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    double displacement_ = 0.0;
    bool isKept_ = false;
};

}  // namespace asperity
