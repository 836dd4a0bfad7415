#pragma once

#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/TipPunch.h"

#include <optional>

namespace asperity {

/// A state of SphereCurve and its derivatives along the curve, in units of the sphere's radius and
/// E*.
struct SphereState {
    LawPoint point;
    double forceRate = 0.0;        ///< of the force, per curve parameter towards higher load
    double indentationRate = 0.0;  ///< of the indentation, per the same parameter
    double perDepth = 0.0;         ///< rate of that parameter by the depth, 0 at the first touch
    double forceSize = 0.0;        ///< sum of the parts whose difference the force is
    double indentationSize = 0.0;  ///< the same for the indentation
};

/// Rigid sphere on an elastic half-space with a cohesive zone of constant stress, continued without
/// contact: MaugisCurve beyond the paraboloid. With contact a state is one depth (SphereContact),
/// without contact one tan(beta / 2) with the cohesive radius sin(beta).
///
/// The zone ends where the gap is the cohesive range, or at the equator where the gap stays below
/// that: beyond it the sphere has no surface. The cohesive radius is then the tip's.
///
/// The condition for the cohesive radius c at a contact radius a is free of cancellation with
/// s = sqrt(c^2 - a^2), q = sqrt(1 - c^2), phi = atan(s / a), theta = atan(s / (a q)):
/// A (s - a phi) + (phi - q theta) + (2 sigma0 / E*) (s phi - (c - a)) = pi/2 h0,
/// in which every bracket is positive and rises with c. Source: docs/theory.md 4.4, 2.4.
class SphereCurve {
public:
    /// @param cohesion 2 sigma0 / E*
    /// @param range of the cohesive stress over the tip radius, h0 / R
    SphereCurve(double cohesion, double range) noexcept : cohesion_(cohesion), range_(range) {}

    [[nodiscard]] double cohesion() const noexcept { return cohesion_; }
    [[nodiscard]] double range() const noexcept { return range_; }

    [[nodiscard]] SphereState contact(const SphereContact& contact) const noexcept;
    /// `halfTangent` from 0 (free) to touch().
    [[nodiscard]] SphereState noncontact(double halfTangent) const noexcept;
    /// Half tangent at which the surfaces first touch; 1 where the zone reaches the equator before.
    [[nodiscard]] double touch() const noexcept;
    /// Returns whether the cohesive zone reaches the equator before the surfaces touch.
    [[nodiscard]] bool wrapsBeforeTouch() const noexcept;
    /// Work done on separate bodies to reach the state along the curve, over E* R^3.
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;

private:
    struct Zone;

    [[nodiscard]] Zone zoneAt(const SphereContact& contact, double width,
                              double height) const noexcept;
    [[nodiscard]] Zone solveZone(const SphereContact& contact) const noexcept;
    [[nodiscard]] double zoneGuess(const SphereContact& contact) const noexcept;
    void setRates(const SphereContact& contact, const Zone& zone,
                  SphereState& state) const noexcept;
    [[nodiscard]] double contactEnergy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double shapeWork(const SphereContact& contact, const Zone& zone) noexcept;

    double cohesion_;
    double range_;
};

/// A sphere on a half-space with adhesion of a finite range: MaugisDugdale beyond the paraboloid,
/// with contact or without, up to the equator. The four functions of ContactLaw.h; real-time safe.
///
/// A cohesive zone that would reach beyond the equator ends there, with the tip's radius for its
/// own: the stress then acts on all of the lower half of the sphere, and the states remain in
/// equilibrium and continuous. Source: docs/theory.md 4.4, 2.4, 2.5.
class SphereMaugisLaw {
public:
    /// @param cohesiveStress sigma0 [Pa], > 0 where the pair has adhesion
    SphereMaugisLaw(const ContactPair& pair, double cohesiveStress) noexcept;

    /// The state with this contact radius, 0 .. tip radius, stable or not [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;
    /// The state without contact with this cohesive radius, 0 .. that of the first touch [m].
    [[nodiscard]] LawPoint apart(double cohesiveRadius) const noexcept;

    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] double onset() const noexcept { return -curve_.range() * units_.length; }

    [[nodiscard]] double cohesiveStress() const noexcept { return cohesiveStress_; }  ///< [Pa]
    /// Transition parameter of the paraboloid of this radius; 0 without adhesion.
    [[nodiscard]] double lambda() const noexcept { return lambda_; }

private:
    [[nodiscard]] SphereState contactAt(double depth) const noexcept;
    [[nodiscard]] double apartFold(double softness) const noexcept;
    [[nodiscard]] SphereState foldState(double softness, double& depth) const noexcept;
    [[nodiscard]] LawPoint climb(double target, double softness, double from) const noexcept;
    [[nodiscard]] LawPoint apartAt(double target, double softness, double from) const noexcept;

    double cohesiveStress_;
    double lambda_;
    SphereUnits units_;
    SphereCurve curve_;
    double touch_;                   ///< half tangent of the first touch, see SphereCurve
    double displacementFold_ = 0.0;  ///< depth; 0 where that fold has no contact
    double loadFold_ = 0.0;          ///< depth of the smallest force
};

}  // namespace asperity
