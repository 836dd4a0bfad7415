#pragma once

#include "core/contact/ContactModel.h"

namespace asperity {

/// What the shape of the deformed surface depends on: an elastic contact with a cohesive zone.
struct CohesiveContact {
    double tipRadius = 0.0;       ///< [m]
    double reducedModulus = 0.0;  ///< E* [Pa]
    double cohesiveStress = 0.0;  ///< sigma0 [Pa]; 0 for Hertz
    double indentation = 0.0;     ///< [m]
    double contactRadius = 0.0;   ///< 0: cohesion without contact [m]
    double cohesiveRadius = 0.0;  ///< the contact radius for Hertz [m]
};

/// Displacement of the surface at distance `radius` >= 0 from the axis, > 0 into the sample [m],
/// sum of both bodies (sampleShare() divides it). Closed form. Source: docs/physics.md 4.3.
[[nodiscard]] double surfaceDisplacement(const CohesiveContact& contact, double radius) noexcept;

/// The same for a state of a model; before snap-in the lift by the van der Waals attraction (< 0),
/// to first order. Bonded, the tail's constant lift of the split law is carried unchanged across
/// the contact and falls off outside of it as the lift by the tail at the joint does.
[[nodiscard]] double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                                         double radius) noexcept;

}  // namespace asperity
