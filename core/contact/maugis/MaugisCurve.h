#pragma once

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

}  // namespace asperity
