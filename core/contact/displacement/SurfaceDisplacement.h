#pragma once

#include "core/contact/displacement/SurfaceProfile.h"
#include "core/contact/laws/ContactModel.h"

namespace asperity {

/// What the shape of the surface at a state of a model depends on, without the tail of the split
/// laws.
[[nodiscard]] CohesiveContact contactProfile(const ContactModel& model,
                                             const ContactState& state) noexcept;

/// By how much the tail of the split laws lifts the bonded surface at `radius`, >= 0 [m]; 0 for
/// other laws. It is constant across the contact and falls off outside of it as the lift by the
/// tail at the joint does.
[[nodiscard]] double tailLift(const ContactModel& model, const ContactState& state,
                              double radius) noexcept;

/// surfaceDisplacement() for a state of a model; before snap-in the lift by the van der Waals
/// attraction (< 0), to first order. Bonded, less tailLift().
[[nodiscard]] double surfaceDisplacement(const ContactModel& model, const ContactState& state,
                                         double radius) noexcept;

}  // namespace asperity
