#pragma once

#include "core/probe/Cantilever.h"
#include "core/probe/ForceDecoupling.h"
#include "core/probe/OpticalLever.h"

namespace asperity {

/// The force that two signals give when nothing is assumed but that it lies in the plane of normal
/// and motion. What the paper does; estimateForce() also knows what to do where this is singular.
struct PlanarForce {
    Vector3 force = Vector3::Zero();  ///< lab frame [N]; zero where singular
    double determinant = 0.0;         ///< p.b, plane normal times blind direction
    bool singular = true;             ///< |determinant| < 1e-12, or no sliding
};

/// @param normal unit, out of the sample, lab frame
/// @param velocity of the tip relative to the sample, lab frame [m/s]
/// Source: docs/theory.md 6.3.
[[nodiscard]] PlanarForce planarForce(const Cantilever& cantilever, const LeverSignals& signals,
                                      const Vector3& normal, const Vector3& velocity) noexcept;

/// The planar force as an estimate; where it is singular, the contact model's force along the
/// normal, with that one's variance. The covariance is that of the signals' noise alone, and
/// nothing is held against the friction law. No allocation.
[[nodiscard]] ForceEstimate planarEstimate(const Cantilever& cantilever,
                                           const DecouplingInput& input) noexcept;

}  // namespace asperity
