#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace asperity {

/// A mean with its 95 % confidence interval; what too few values do not tell is no number.
struct Estimate {
    std::size_t count = 0;  ///< of the values
    double mean = 0.0;
    double deviation = 0.0;  ///< of a single value
    double low = 0.0;        ///< of the interval
    double high = 0.0;       ///< of the interval

    /// Returns whether there are enough values for an interval.
    [[nodiscard]] bool hasInterval() const noexcept {
        return std::isfinite(low) && std::isfinite(high) && count > 1;
    }
    [[nodiscard]] bool isAbove(double value) const noexcept { return low > value; }
    [[nodiscard]] bool isBelow(double value) const noexcept { return high < value; }
};

/// Of independent values, by Student's t. Source: Student (1908).
[[nodiscard]] Estimate estimateOf(std::span<const double> values);

/// Pearson's correlation of pairs, with the interval of Fisher's transformation. `mean` is the
/// correlation, `deviation` is no number. Source: Fisher (1921).
[[nodiscard]] Estimate correlationOf(std::span<const double> x, std::span<const double> y);

/// Slope of the straight line through pairs, by least squares; no number where all x are equal.
[[nodiscard]] double slopeOf(std::span<const double> x, std::span<const double> y);

}  // namespace asperity
