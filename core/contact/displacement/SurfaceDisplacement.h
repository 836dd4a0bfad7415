#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/FilmTable.h"

namespace asperity {

/// Undeformed shape of the tip around its lowest point.
enum class TipShape {
    Paraboloid,  ///< r^2 / 2R, of Hertz, DMT, JKR, Maugis and Dugdale
    Sphere  ///< up to the equator, r = R, or to a cone: the exact laws of docs/theory.md 4.4, 4.8
};

/// Parameters of the deformed surface's shape, for every contact law: an elastic contact, whose
/// edge is closed smoothly (Hertz, DMT), by a cohesive zone (Maugis) or singularly (JKR).
struct CohesiveContact {
    double tipRadius = 0.0;       ///< [m]
    double reducedModulus = 0.0;  ///< E* [Pa]
    double cohesiveStress = 0.0;  ///< sigma0 [Pa]; 0 without a cohesive zone
    double indentation = 0.0;     ///< [m]
    double contactRadius = 0.0;   ///< 0: cohesion without contact [m]
    double cohesiveRadius = 0.0;  ///< the contact radius without a cohesive zone [m]
    double edgeWork = 0.0;        ///< work of adhesion of the JKR laws, 0 for others [J/m^2]
    TipShape shape = TipShape::Paraboloid;
    double coneHalfAngle = 0.0;       ///< of the cone that a sphere goes on as [rad]; 0: none
    const FilmTable* film = nullptr;  ///< that the law takes the sample for; null: a half-space
    double filmThickness = 0.0;       ///< [m]
};

/// Beyond this distance the surface counts as undisturbed [m].
inline constexpr double kFarAway = 1e3;

/// Displacement of the surface at distance `radius` >= 0 from the axis, > 0 into the sample [m],
/// sum of both bodies (sampleShare() divides it); 0 for a radius outside 0 .. kFarAway. Bounded, no
/// allocation. Source: docs/theory.md 4.3, 4.4, 4.8.
[[nodiscard]] double surfaceDisplacement(const CohesiveContact& contact, double radius) noexcept;

/// Distance between surface and tip at `radius` [m], 0 in contact. Of a sphere without a cone, up
/// to its equator (beyond it the equator's height counts).
[[nodiscard]] double surfaceGap(const CohesiveContact& contact, double radius) noexcept;

/// Pressure on the surface at `radius`, > 0 compression [Pa]; without the attraction that DMT adds
/// outside of the contact. -infinity at the very edge of a JKR contact.
[[nodiscard]] double contactPressure(const CohesiveContact& contact, double radius) noexcept;

/// Returns the parameters of the surface's shape at a state of a model, without the tail of the
/// split laws.
[[nodiscard]] CohesiveContact contactProfile(const ContactModel& model,
                                             const ContactState& state) noexcept;

/// Returns by how much the tail of the split laws lifts the bonded surface at `radius`, >= 0 [m]; 0
/// for other laws. It is constant across the contact and falls off outside of it as the lift by the
/// tail at the joint does.
[[nodiscard]] double tailLift(const ContactModel& model, const ContactState& state,
                              double radius) noexcept;

/// surfaceDisplacement() for a state of a model; before snap-in the lift by the van der Waals
/// attraction (< 0), to first order. Bonded, less tailLift().
[[nodiscard]] double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                                         double radius) noexcept;

}  // namespace asperity
