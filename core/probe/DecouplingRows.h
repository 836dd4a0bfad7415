#pragma once

#include "core/probe/ForceDecoupling.h"
#include "core/probe/Sliding.h"

#include <cmath>

/// What decoupling and innovation monitor share: the friction law as an observation with a standard
/// deviation. Source: docs/theory.md 6.5.
namespace asperity::decoupling {

inline constexpr double kPlanarityDefect = 0.02;   // eta_p
inline constexpr double kFrictionLawDefect = 0.3;  // eta_f
inline constexpr double kMinFriction = 1e-12;      // S0 [N]

/// Normal and sliding in the cantilever frame.
struct ContactGeometry {
    Vector3 normal = Vector3::UnitZ();
    Sliding sliding;
};

[[nodiscard]] inline ContactGeometry geometryOf(const Cantilever& cantilever,
                                                const DecouplingInput& in) noexcept {
    const Vector3 normal = (cantilever.rotation() * in.normal).normalized();
    return {normal, slidingOf(normal, cantilever.rotation() * in.velocity)};
}

/// tau A [N].
[[nodiscard]] inline double adhesiveFriction(const DecouplingInput& in) noexcept {
    return in.shearStrength * in.contactArea;
}

/// Nobody knows a friction coefficient better than to this: a law of less is not certain of it.
inline constexpr double kMinFrictionShare = 0.04;

/// What the friction law may be off by beside its own 30 %, at any load [N].
[[nodiscard]] inline double leastLawError(const DecouplingInput& in, double stated) noexcept {
    const double least = kMinFrictionShare * std::abs(in.normalForceModel);
    return least > stated ? std::sqrt((least * least) - (stated * stated)) : 0.0;
}

/// S of docs/theory.md 6.5 [N].
[[nodiscard]] inline double frictionScale(const DecouplingInput& in) noexcept {
    return (in.frictionCoefficient * std::abs(in.normalForceModel)) + adhesiveFriction(in) +
           kMinFriction;
}

}  // namespace asperity::decoupling
