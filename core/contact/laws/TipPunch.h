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

/// A sphere that goes on to its equator, or whose tangent cone begins at the radius R cos(alpha).
class TipPunch {
public:
    /// @param coneHalfAngle alpha, between the cone and its axis, 0 .. pi/2 [rad]; 0: no cone
    explicit TipPunch(double coneHalfAngle = 0.0) noexcept;

    [[nodiscard]] bool hasCone() const noexcept { return sine_ > 0.0; }
    /// Radius at which the cone begins; 1, the equator, without one.
    [[nodiscard]] double jointRadius() const noexcept { return cosine_; }

    [[nodiscard]] PunchContact contact(double coordinate) const noexcept;
    /// The contact with this radius; as sphereContactOfRadius() without a cone.
    [[nodiscard]] PunchContact contactOfRadius(double radius) const noexcept;

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
