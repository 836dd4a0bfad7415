#pragma once

#include "core/Vector.h"
#include "core/probe/Cantilever.h"

namespace asperity {

/// What the optical lever tells: the slope at the tip, and so of the straight rest of the beam up
/// to its free end, about two axes.
struct LeverSignals {
    double bending = 0.0;  ///< alpha = dz/dx at the tip [rad]
    double torsion = 0.0;  ///< theta [rad]
};

/// Signals that a force on the tip (lab frame [N]) causes. Source: docs/theory.md 5.2, 5.4.
[[nodiscard]] LeverSignals leverSignals(const Cantilever& cantilever,
                                        const Vector3& force) noexcept;

}  // namespace asperity
