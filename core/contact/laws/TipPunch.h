#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"

#include <limits>

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

/// Units that convert the numbers of a unit sphere on a half-space of unit modulus to SI.
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

/// Contact of a half-space with a rigid tip, without adhesion, in units of the radius of the sphere
/// that ends the tip. The edge of the contact lies on the sphere or on the cone that goes on from
/// it. Source: docs/theory.md 4.8.
struct PunchContact {
    /// Along the tip, from 0 (no contact) on: the depth while on the sphere, beyond that as the
    /// radius, with the same rate at the joint.
    double coordinate = 0.0;
    double depth = 0.0;      ///< indentation over contact radius
    double radius = 0.0;     ///< a
    double rim = 0.0;        ///< square root of the rate of the radius by the coordinate
    double depthRate = 1.0;  ///< of the depth, by the coordinate
    double run = 0.0;        ///< sqrt(a^2 - r0^2) beyond the radius r0 of the joint; else 0
};

/// A contact within a wider one, as integrals over its radius need it.
struct PunchRing {
    double radius = 0.0;
    double indentation = 0.0;  ///< elastic
    double rate = 0.0;         ///< of the indentation, by the radius
};

/// A sphere that goes on to its equator, or whose tangent cone begins at the radius R cos(alpha).
class TipPunch {
public:
    /// @param coneHalfAngle alpha, between the cone and its axis, 0 .. pi/2 [rad]; 0: no cone
    explicit TipPunch(double coneHalfAngle = 0.0) noexcept;

    [[nodiscard]] bool hasCone() const noexcept { return sine_ > 0.0; }
    /// Radius at which the cone begins; 1, the equator, without one.
    [[nodiscard]] double jointRadius() const noexcept { return cosine_; }
    /// Coordinate there; infinite without a cone.
    [[nodiscard]] double jointCoordinate() const noexcept { return joint_; }
    /// Sine of the half angle, and height of the joint below the sphere's center; 0 without a cone.
    [[nodiscard]] double sine() const noexcept { return sine_; }
    /// Slope of the cone, its cotangent; 0 without one.
    [[nodiscard]] double slope() const noexcept { return slope_; }

    [[nodiscard]] PunchContact contact(double coordinate) const noexcept;
    /// The contact with this radius; as sphereContactOfRadius() without a cone.
    [[nodiscard]] PunchContact contactOfRadius(double radius) const noexcept;

    /// A ring on the sphere, of a radius below 1 and up to the joint.
    [[nodiscard]] static PunchRing sphereRing(double radius) noexcept;
    /// A ring on the cone. @param run as PunchContact has it
    [[nodiscard]] PunchRing coneRing(double run) const noexcept;

    /// Force, in units of E* R^2.
    [[nodiscard]] double force(const PunchContact& contact) const noexcept;
    /// Elastic energy of the surface pressed to the tip within the contact radius at this
    /// indentation, in units of E* R^3.
    [[nodiscard]] double elasticEnergy(const PunchContact& contact,
                                       double indentation) const noexcept;

private:
    [[nodiscard]] PunchContact onCone(double excess, double coordinate) const noexcept;
    [[nodiscard]] double sphereLogarithm(double radius, double run) const noexcept;
    [[nodiscard]] double sphereShare(double radius, double run) const noexcept;
    [[nodiscard]] double coneSquareMoment(double run) const noexcept;

    double sine_ = 0.0;
    double cosine_ = 1.0;
    double slope_ = 0.0;                                      ///< of the cone: cot(alpha)
    double joint_ = std::numeric_limits<double>::infinity();  ///< coordinate where the cone begins
};

/// Integrals over the contacts between a contact radius a and the radius c of the cohesive zone
/// around it, of their elastic indentation d(t), in units of the sphere's radius.
struct ZoneIntegrals {
    double opening = 0.0;  ///< of (d(t) - d(a)) / sqrt(c^2 - t^2)
    double spread = 0.0;   ///< of d'(t) t / sqrt(c^2 - t^2), over c
    double work = 0.0;     ///< of (d(t) - d(a)) sqrt(c^2 - t^2)

    ZoneIntegrals& operator+=(const ZoneIntegrals& other) noexcept;
};

[[nodiscard]] ZoneIntegrals operator+(ZoneIntegrals one, const ZoneIntegrals& other) noexcept;
[[nodiscard]] ZoneIntegrals operator*(double factor, const ZoneIntegrals& integrals) noexcept;

/// Returns the integrals of a zone, to some 1e-12. Real-time safe. Source: docs/theory.md 4.8.
/// @param punch with a cone  @param width sqrt(c^2 - a^2)
[[nodiscard]] ZoneIntegrals zoneIntegrals(const TipPunch& punch, const PunchContact& contact,
                                          double width) noexcept;

/// Returns the integral of the elastic indentation d(t) / sqrt(r^2 - t^2) over the part of a
/// contact on the cone: by how much the cone leaves the surface at r unpressed.
/// @param run of the contact's edge, > 0  @param radius r, at least the contact's
[[nodiscard]] double coneTransform(const TipPunch& punch, double run, double radius) noexcept;

/// Returns the integral of d'(t) / sqrt(t^2 - r^2) over the part of a contact on the cone and
/// beyond r: pi times the pressure of a half-space of unit modulus at r that the cone causes.
/// @param run of the contact's edge, > 0  @param radius r, less than the contact's
[[nodiscard]] double conePressure(const TipPunch& punch, double run, double radius) noexcept;

}  // namespace asperity
