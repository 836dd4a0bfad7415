#pragma once

#include <cmath>

namespace asperity {

/// Returns whether low <= value <= high; false for a NaN, and quietly so: comparing one would raise
/// the floating-point flag "invalid".
[[nodiscard]] inline bool isWithin(double value, double low, double high) noexcept {
    return std::isfinite(value) && value >= low && value <= high;
}

}  // namespace asperity
