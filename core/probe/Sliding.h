#pragma once

#include "core/Vector.h"

namespace asperity {

inline constexpr double kRestSpeed = 1e-9;  ///< v0, below which friction fades [m/s]

/// How a tip slides over a surface: direction of friction and how surely it has one.
struct Sliding {
    Vector3 friction = Vector3::Zero();  ///< unit, against the motion; any tangent at rest
    double certainty = 0.0;              ///< g = |v_t| / sqrt(|v_t|^2 + v0^2), v0 = kRestSpeed
    double doubt = 1.0;                  ///< sqrt(1 - g^2)

    /// Direction of friction, fading smoothly to zero at rest.
    [[nodiscard]] Vector3 slip() const noexcept { return certainty * friction; }
};

/// Sliding of a tip that moves with `velocity` [m/s] over a surface with unit `normal`, both in one
/// frame. Source: docs/theory.md 6.2, 6.5.
[[nodiscard]] Sliding slidingOf(const Vector3& normal, const Vector3& velocity) noexcept;

}  // namespace asperity
