#pragma once

#include "core/contact/laws/LawPoint.h"
#include "core/contact/laws/SphereCurve.h"

#include <optional>

namespace asperity {

/// A sphere on a half-space with adhesion of a finite range: MaugisDugdale beyond the paraboloid,
/// with contact or without, up to the equator. The four functions of LawPoint.h; real-time safe.
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
