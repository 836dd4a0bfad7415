#pragma once

#include "core/map/RetractCurve.h"

#include <span>

namespace asperity {

/// Reduced modulus E* that an instrument reports [Pa]: the law of Derjaguin, Muller and Toporov,
///
///     F = 4/3 E* sqrt(R) d^(3/2) - F_adhesion,
///
/// fitted to the unloading part of a retract between 30 % and 90 % of the way from the strongest
/// pull up to the setpoint, with the tip's own radius R [m] and the height of the tip as recorded,
/// along z: neither the curvature nor the slope of the sample is known to it. A least-squares line
/// through (F + F_adhesion)^(2/3) over the height; place and slope are free.
/// NaN: fewer than three points, or the force does not rise.
/// @param adhesion F_adhesion, > 0 pulls [N]
/// Source: docs/theory.md 2.1; usual practice of quantitative mapping.
[[nodiscard]] double dmtModulus(std::span<const RetractPoint> unloading, double adhesion,
                                double tipRadius) noexcept;

}  // namespace asperity
