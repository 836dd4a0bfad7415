#pragma once

#include "core/contact/Material.h"
#include "core/contact/laws/LawPoint.h"

namespace asperity {

/// Contact of a half-space with a rigid sphere up to its equator, in units of the sphere's radius.
/// `depth` runs from 0 (no contact) to infinity (the contact circle reaches the equator) and keeps
/// full precision at both ends. Source: docs/theory.md 4.4.
struct SphereContact {
    double depth = 0.0;   ///< A = atanh(a)
    double radius = 0.0;  ///< a = tanh(A)
    double rim = 0.0;     ///< sqrt(1 - a^2), height of the contact's edge below the center
};

[[nodiscard]] SphereContact sphereContact(double depth) noexcept;

/// The contact with this radius, 0 .. 1; from 1 - 1e-17 on the depth is cut off.
[[nodiscard]] SphereContact sphereContactOfRadius(double radius) noexcept;

/// Force without adhesion, in units of E* R^2. Source: Sneddon (1965).
[[nodiscard]] double sphereForce(const SphereContact& contact) noexcept;

/// Elastic energy of the surface pressed to the sphere within the contact radius at this
/// indentation, in units of E* R^3: integral of g(t)^2 of docs/theory.md 4.1 over the contact.
[[nodiscard]] double sphereElasticEnergy(const SphereContact& contact, double indentation) noexcept;

/// What brings the numbers of a unit sphere on a half-space of unit modulus to SI.
struct SphereUnits {
    double length = 0.0;     ///< R [m]
    double stiffness = 0.0;  ///< E* R [N/m]

    explicit SphereUnits(const ContactPair& pair) noexcept;

    [[nodiscard]] double force() const noexcept { return stiffness * length; }  ///< [N]
    [[nodiscard]] double energy() const noexcept { return force() * length; }   ///< [J]
    [[nodiscard]] LawPoint toSi(const LawPoint& point) const noexcept;
    [[nodiscard]] LawPoint fromSi(const LawPoint& point) const noexcept;
};

/// Ratio of two rates along a curve; 1e30 in size where the curve is steeper than that, as at the
/// end of the branch in displacement control.
[[nodiscard]] double boundedSlope(double forceRate, double indentationRate) noexcept;

}  // namespace asperity
