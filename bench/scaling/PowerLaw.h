#pragma once

#include <span>

namespace asperity {

/// y = factor x^exponent: a straight line on two logarithmic axes, whose slope is the exponent.
struct PowerLaw {
    double factor = 1.0;
    double exponent = 0.0;

    [[nodiscard]] double at(double x) const;
};

/// The power law with the least squares of the logarithms.
/// @param y as many as `x`
/// @throw Error when a value is not positive or fewer than two of `x` differ
[[nodiscard]] PowerLaw fitPowerLaw(std::span<const double> x, std::span<const double> y);

}  // namespace asperity
