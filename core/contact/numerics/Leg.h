#pragma once

#include <algorithm>
#include <cmath>

namespace asperity {

/// sqrt(large^2 - small^2) without cancellation; 0 where that is not real.
[[nodiscard]] inline double leg(double large, double small) noexcept {
    return std::sqrt(std::max(0.0, large - small) * (large + small));
}

}  // namespace asperity
