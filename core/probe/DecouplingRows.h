#pragma once

#include "core/probe/ForceDecoupling.h"
#include "core/probe/ProbeSystem.h"

#include <algorithm>
#include <cmath>

/// Parts that decoupling and innovation monitor share: the friction law as an observation with a
/// standard deviation. Source: docs/theory.md 6.5.
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

/// Least error of the friction law beside its own 30 %, at any load [N].
[[nodiscard]] inline double leastLawError(const DecouplingInput& in, double stated) noexcept {
    const double least = kMinFrictionShare * std::abs(in.normalForceModel);
    return least > stated ? std::sqrt((least * least) - (stated * stated)) : 0.0;
}

/// S of docs/theory.md 6.5 [N].
[[nodiscard]] inline double frictionScale(const DecouplingInput& in) noexcept {
    return (in.frictionCoefficient * std::abs(in.normalForceModel)) + adhesiveFriction(in) +
           kMinFriction;
}

/// Errors that a normal that may be turned adds to those of planarity, friction law and contact
/// model: standard deviations, or their opposites [N].
struct NormalErrors {
    double across = 0.0;  ///< of the force across the plane of normal and friction
    double along = 0.0;   ///< of the friction law; the same turn is in `normal`, with opposite sign
    double normal = 0.0;  ///< of the contact model
    double apart = 0.0;   ///< of the friction law, and of nothing else
};

/// @param geometry of `in`
/// Source: docs/theory.md 6.7.
[[nodiscard]] inline NormalErrors normalErrors(const DecouplingInput& in,
                                               const ContactGeometry& geometry) noexcept {
    const Sliding& sliding = geometry.sliding;
    const double deviation = in.normalDeviation;
    if (deviation == 0.0) {
        return {};
    }
    const double load = in.normalForceModel;
    const double law = (in.frictionCoefficient * load) + adhesiveFriction(in);
    const double friction = sliding.certainty * std::max(0.0, law);
    // Over sqrt(v_t^2 + v0^2): a motion that is nearly normal hardly says where the tip slides.
    const double normalSpeed = in.velocity.dot(in.normal.normalized());
    const double turn = deviation * normalSpeed * sliding.doubt / kRestSpeed;
    const double aside = turn / std::hypot(1.0, turn);
    const double ofUnknownLoad = deviation * in.normalForceSigma;
    const double ofUnknownFriction = kFrictionLawDefect * friction * aside;
    return {.across = std::hypot((deviation * load) + (friction * aside),
                                 std::hypot(ofUnknownLoad, ofUnknownFriction)),
            .along = deviation * (load + (sliding.certainty * in.frictionCoefficient * friction)),
            .normal = deviation * friction,
            .apart = std::hypot(friction * aside * aside, ofUnknownLoad)};
}

}  // namespace asperity::decoupling
