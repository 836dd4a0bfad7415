#pragma once

#include "core/map/JumpSearch.h"

#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// A point of a retract as the instrument records it.
struct RetractPoint {
    double height = 0.0;  ///< of the tip, from base and deflection along z [m]
    double force = 0.0;   ///< along z [N]
};

/// The way of the tip from the setpoint until it is free.
struct RetractCurve {
    /// States from the setpoint to the last one before the pull-off. Without states that were not
    /// found: near the pull-off a lever that bends to the side may have none, and their force none.
    std::vector<RetractPoint> bonded;
    std::vector<RetractPoint> free;  ///< after it, until the force is 0.1 % of the strongest pull
    FoundJump pullOff;
    TipAtHeight strongest;  ///< where the tip pulls hardest of all states before the pull-off
    double jumpWork = 0.0;  ///< area under the pull while the tip pulls off, the base at rest [J]
};

/// Raises the base from the setpoint in about 32 steps until the tip pulls off, and on.
/// None: it stays bonded. @param atSetpoint in equilibrium
[[nodiscard]] std::optional<RetractCurve> retract(VerticalPath& path, TipAtHeight atSetpoint);

/// Area between the retract and zero force, where it pulls, over the height of the tip [J]. The
/// deflection of an elastic lever adds none: over the base's height it is the same. Trapezoids; of
/// the free tip, whose attraction falls with the square of the distance, all of it to infinity.
[[nodiscard]] double separationWork(const RetractCurve& curve) noexcept;

/// On one contact point, where the law pulls hardest before the pull-off, without the error of the
/// steps; none: on several, the force does not jump, or the state before the jump was not found.
/// The law is that of the position of the strongest state: on a flank a bent lever moves the tip on
/// to another effective radius until it pulls off.
[[nodiscard]] std::optional<RetractPoint> strongestOfLaw(const VerticalPath& path,
                                                         const RetractCurve& curve) noexcept;

/// Along z, the strongest pull on the way [N]; 0 where it never pulls. On one contact point it is
/// the law's own, without the error of the steps.
[[nodiscard]] double strongestPull(const VerticalPath& path, const RetractCurve& curve) noexcept;

/// Reduced modulus E* that an instrument reports [Pa]: the law of Derjaguin, Muller and Toporov,
///
///     F = 4/3 E* sqrt(R) d^(3/2) - F_adhesion,
///
/// fitted to the unloading part of a retract between 30 % and 90 % of the way from the strongest
/// pull up to the setpoint, with the tip's own radius R [m] and the height of the tip as recorded,
/// along z: neither the curvature nor the slope of the sample is known to it. A least-squares line
/// through (F + F_adhesion)^(2/3) over the height; position and slope are free.
/// NaN: fewer than three points, or the force does not rise.
/// @param adhesion F_adhesion, > 0 pulls [N]
/// Source: docs/theory.md 2.1; usual practice of quantitative mapping.
[[nodiscard]] double dmtModulus(std::span<const RetractPoint> unloading, double adhesion,
                                double tipRadius) noexcept;

}  // namespace asperity
