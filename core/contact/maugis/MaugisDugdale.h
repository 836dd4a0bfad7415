#pragma once

#include "core/contact/ContactState.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// One state of the dimensionless Maugis-Dugdale curve and its derivatives along the curve. Lengths
/// across the surface are in units of (pi w R^2 / K)^(1/3), forces of pi w R, lengths along the
/// normal of (pi^2 w^2 R / K^2)^(1/3), K = 4/3 E*.
struct MaugisPoint {
    double coordinate = 0.0;       ///< cot(phi), see MaugisCurve; 0 without contact
    double angle = 0.0;            ///< phi = acos(contactRadius / cohesiveRadius)
    double contactRadius = 0.0;    ///< 0: the cohesive zone has no contact in it
    double cohesiveRadius = 0.0;   ///< outer radius of the cohesive zone
    double force = 0.0;            ///< > 0 repulsive
    double indentation = 0.0;      ///< < 0: a gap
    double forceRate = 0.0;        ///< of the force, per curve parameter towards higher load
    double indentationRate = 0.0;  ///< of the indentation, per the same parameter
};

/// Contact with a cohesive zone of constant stress (Maugis), continued without contact (Kim,
/// McMeeking, Johnson), by an explicit parametrization free of cancellation: every state with
/// contact is one `coordinate` cot(phi), from 0 (first touch) to infinity (high load).
/// Valid for transition parameters 1e-13 .. 1e7. Source: docs/theory.md 2.3, 2.4, 2.6.
class MaugisCurve {
public:
    explicit MaugisCurve(double lambda) noexcept : lambda_(lambda) {}

    [[nodiscard]] double lambda() const noexcept { return lambda_; }

    /// State with contact; `coordinate` >= 0.
    [[nodiscard]] MaugisPoint contact(double coordinate) const noexcept;
    /// State without contact; `cohesiveRadius` from 0 (free) to touchRadius().
    [[nodiscard]] MaugisPoint noncontact(double cohesiveRadius) const noexcept;
    /// Cohesive radius at which the surfaces first touch: both kinds of state meet there.
    [[nodiscard]] double touchRadius() const noexcept;
    /// Gap at which the cohesive stress sets in, h0 in units of the indentation.
    [[nodiscard]] double range() const noexcept;
    /// Work done on the free state to reach this one along the curve, the integral of force over
    /// indentation. Rounding grows as 1e-16 lambda.
    [[nodiscard]] double energy(const MaugisPoint& point) const noexcept;

private:
    [[nodiscard]] double cohesiveWork(const MaugisPoint& point) const noexcept;

    double lambda_;
};

/// Quantity that is held while tip and sample find their equilibrium, in the units of MaugisPoint:
/// the sum perIndentation * indentation + perForce * force.
struct MaugisControl {
    double perIndentation = 0.0;
    double perForce = 0.0;

    static constexpr MaugisControl load() noexcept { return {0.0, 1.0}; }
    static constexpr MaugisControl displacement() noexcept { return {1.0, 0.0}; }
    /// The base of a spring; its compliance in units of indentation over force, >= 0.
    static constexpr MaugisControl spring(double compliance) noexcept { return {1.0, compliance}; }

    [[nodiscard]] constexpr double held(const MaugisPoint& point) const noexcept {
        return (perIndentation * point.indentation) + (perForce * point.force);
    }
    /// Its rate along the curve towards higher load: stable states have > 0.
    [[nodiscard]] constexpr double heldRate(const MaugisPoint& point) const noexcept {
        return (perIndentation * point.indentationRate) + (perForce * point.forceRate);
    }
};

/// Stable equilibria of the Maugis-Dugdale curve and the folds where they end. The stable branch
/// runs from high load to one fold, with contact or without. Bounded, no allocation.
/// Source: docs/theory.md 2.5, 2.7, 7.1.
class MaugisDugdale {
public:
    /// Time at which the fold in load control is found: at once, for laws that many cold solutions
    /// are asked of, or on each request: a law that follows a path never makes one.
    enum class LoadFold : std::uint8_t { Kept, OnDemand };

    explicit MaugisDugdale(double lambda, LoadFold loadFold = LoadFold::Kept) noexcept;

    [[nodiscard]] const MaugisCurve& curve() const noexcept { return curve_; }

    /// The state with contact and the smallest indentation: the fold in displacement control, or
    /// first touch where that fold has no contact.
    [[nodiscard]] const MaugisPoint& lowestContact() const noexcept { return lowestContact_; }
    /// End of the stable branch: the smallest value that can be held in contact or cohesion.
    [[nodiscard]] MaugisPoint fold(const MaugisControl& control) const noexcept;
    /// The stable state at a held value; none below the fold.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control,
                                                    double value) const noexcept;
    /// The same state to rounding, by Newton's method from a state near it, such as the previous
    /// one of a slow motion, of this transition parameter or one close to it. A `start` far away or
    /// without contact only costs time.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control, double value,
                                                    const MaugisPoint& start) const noexcept;
    /// The same from the coordinate of such a state, one evaluation of the curve more; any number
    /// is allowed, even one that is not.
    [[nodiscard]] std::optional<MaugisPoint> stable(const MaugisControl& control, double value,
                                                    double start) const noexcept;
    /// The state with this contact radius (> 0), stable or not.
    [[nodiscard]] MaugisPoint atContactRadius(double contactRadius) const noexcept;

private:
    /// The smallest force of all states.
    [[nodiscard]] MaugisPoint loadFold() const noexcept;
    [[nodiscard]] MaugisPoint climb(const MaugisControl& control, double value,
                                    const MaugisPoint& from) const noexcept;
    [[nodiscard]] std::optional<MaugisPoint> follow(const MaugisControl& control, double value,
                                                    const MaugisPoint& start) const noexcept;
    [[nodiscard]] bool isSurelyStable(const MaugisControl& control,
                                      const MaugisPoint& point) const noexcept;
    [[nodiscard]] MaugisPoint stableNoncontact(const MaugisControl& control,
                                               double value) const noexcept;

    MaugisCurve curve_;
    MaugisPoint touch_;  ///< first touch, as a state without contact
    std::optional<MaugisPoint> loadFold_;
    MaugisPoint lowestContact_;  ///< end of the stable states with contact, by indentation
};

/// Units of the dimensionless Maugis-Dugdale curve for one material pair and cohesive stress.
/// Source: docs/theory.md 1.
struct MaugisUnits {
    double radius = 0.0;       ///< of contact and cohesive radius [m]
    double force = 0.0;        ///< pi w R [N]
    double indentation = 0.0;  ///< [m]

    [[nodiscard]] double energy() const noexcept { return force * indentation; }  ///< [J]
};

[[nodiscard]] MaugisUnits maugisUnits(const ContactPair& pair) noexcept;

/// Transition parameter lambda: near 0 for stiff, small tips (DMT), large for soft, large ones
/// (JKR).
/// @param cohesiveStress sigma0 [Pa]
[[nodiscard]] double transitionParameter(const MaugisUnits& units, double cohesiveStress) noexcept;

}  // namespace asperity
