#pragma once

#include "core/contact/laws/SpherePunch.h"

#include <limits>

namespace asperity {

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

}  // namespace asperity
