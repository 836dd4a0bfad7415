#pragma once

#include "core/SiFormat.h"

#include <string>

namespace asperity {

/// A unit prefix that stays the same while the values do not change much.
class SteadyScale {
public:
    /// @param unit SI unit without prefix
    /// @param smallest magnitude below which values count as this [unit], > 0
    SteadyScale(std::string unit, double smallest);

    /// The prefix for values up to `magnitude` [unit]. A larger prefix comes at once, a smaller one
    /// only when the values fall well below one. What is not finite changes nothing.
    const SiScale& fit(double magnitude);
    [[nodiscard]] const SiScale& scale() const noexcept { return scale_; }

private:
    std::string unit_;  ///< SI, without prefix
    double smallest_;   ///< [unit]
    SiScale scale_;
};

/// The limits of an axis.
struct AxisRange {
    double low = 0.0;   ///< [unit of the data]
    double high = 0.0;  ///< [unit of the data]
};

/// Axis limits at round numbers that hold the data and seldom change: they widen at once, and
/// narrow only when the data fill little of them.
class SteadyRange {
public:
    /// @param smallest least distance of the limits, > 0
    explicit SteadyRange(double smallest);

    /// Limits for data between `low` and `high`; what is not finite changes nothing.
    const AxisRange& fit(double low, double high);
    [[nodiscard]] const AxisRange& range() const noexcept { return range_; }

private:
    double smallest_;  ///< [unit of the data]
    AxisRange range_;
};

/// Exaggeration of something small so that it shows: 1, 2 or 5 times a power of ten that
/// seldom changes.
class SteadyFactor {
public:
    /// @param smallest magnitude below which values count as this, > 0
    explicit SteadyFactor(double smallest) : smallest_(smallest) {}

    /// The factor that brings `magnitude` near `target` (> 0) but not above it.
    double fit(double magnitude, double target);
    [[nodiscard]] double factor() const noexcept { return factor_; }

private:
    double smallest_;      ///< [unit of the data]
    double factor_ = 1.0;  ///< dimensionless
};

/// A value in a given prefix for people, "-12.30 nN"; "– nN" when it is not finite.
[[nodiscard]] std::string scaledText(double value, const SiScale& scale, int decimals);

/// The same to three significant digits, however small: "12.3 nN", "0.0405 N/m".
[[nodiscard]] std::string significantText(double value, const SiScale& scale);

/// The same to three digits, and never finer than a hundredth: "-12.3 nN", "0.02 nN", "0 nN".
[[nodiscard]] std::string threeDigitText(double value, const SiScale& scale);

}  // namespace asperity
