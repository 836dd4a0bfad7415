#pragma once

#include "core/contact/laws/SphereCurve.h"
#include "core/contact/laws/TipPunch.h"

namespace asperity {

/// A rigid sphere that goes on as a cone, on an elastic half-space with a cohesive zone of constant
/// stress: SphereCurve beyond the equator. In units of the sphere's radius and E*. A state with
/// contact is one coordinate of TipPunch, one without contact its cohesive radius.
///
/// With s = sqrt(c^2 - a^2), phi = atan(s / a), k = 2 sigma0 / E* and the elastic indentation d and
/// force p of the contact: indentation d(a) - k s, force p(a) - k (c^2 phi + a s), and c from
/// int_a^c (d(t) - d(a)) / sqrt(c^2 - t^2) dt + k (s phi - (c - a)) = pi/2 h0,
/// in which both terms are positive and rise with c. Source: docs/theory.md 4.8.
class ConeCurve {
public:
    /// @param cohesion 2 sigma0 / E*
    /// @param range of the cohesive stress over the tip radius, h0 / R, > 0
    /// @param coneHalfAngle > 0 [rad]
    ConeCurve(double cohesion, double range, double coneHalfAngle) noexcept;

    [[nodiscard]] const TipPunch& punch() const noexcept { return punch_; }
    [[nodiscard]] double cohesion() const noexcept { return cohesion_; }
    [[nodiscard]] double range() const noexcept { return range_; }
    /// Cohesive radius at which the surfaces first touch.
    [[nodiscard]] double touch() const noexcept { return touch_; }

    /// The rates are by the curve's own parameter, `perDepth` that of it by the coordinate.
    [[nodiscard]] SphereState contact(double coordinate) const noexcept;
    /// Rates by the cohesive radius, from 0 (free) to touch().
    [[nodiscard]] SphereState noncontact(double cohesiveRadius) const noexcept;
    /// Work done on separate bodies to reach the state along the curve, over E* R^3.
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;

private:
    struct Zone;

    [[nodiscard]] Zone zoneAt(const PunchContact& contact, double width) const noexcept;
    [[nodiscard]] double zoneGuess(const PunchContact& contact) const noexcept;
    [[nodiscard]] Zone solveZone(const PunchContact& contact) const noexcept;
    [[nodiscard]] double touchingRadius() const noexcept;
    [[nodiscard]] double tipHeight(double radius) const noexcept;

    double cohesion_;
    double range_;
    TipPunch punch_;
    double touch_;
};

}  // namespace asperity
