#pragma once

#include <algorithm>

namespace asperity {

/// Returns a value from 0 below 0 to 1 above 1, level at both ends.
[[nodiscard]] inline double smoothStep(double value) noexcept {
    const double part = std::clamp(value, 0.0, 1.0);
    return part * part * (3.0 - 2.0 * part);
}

}  // namespace asperity
