#pragma once

#include "core/contact/laws/ContactModel.h"

namespace asperity {

/// Whether a contact law leaves out what acts on the tip at one of its states: adhesion, its range,
/// or the curvature of a sphere beyond that of its paraboloid. No allocation.
///
/// - without adhesion (`hertz`, `sneddon`, `hertz_film`): adhesive pairs below 280 pi w R of load,
///   where adhesion changes the contact radius by more than 5 %;
/// - `dmt`: lambda above 2.5e-4, where the ring of attraction, by lifting the sample by 1.5
///   sqrt(lambda) units, changes the force at a given indentation by 5 % (2.5, 2.7);
/// - `jkr`, `jkr_sphere`: lambda below 4.8 (1 % of the unloaded radius);
/// - all three, while apart, within the range of adhesion, which they do not have;
/// - `jkr`, `md`, `split`: attraction beyond 0.3 R of the axis, where the gap under the paraboloid
///   is 2.3 % narrower than under the sphere; while apart, and `dmt` always, tips whose attraction
///   reaches so far when they are bonded without load;
/// - `md_sphere`, `split_sphere` without a cone: attraction up to the sphere's equator.
///
/// The range of adhesion is that of the model, ContactModel::cohesiveRange().
/// Source: docs/theory.md 2.4, 2.5, 2.9, 4.4.
[[nodiscard]] bool leavesLawsRange(const ContactModel& model, const ContactState& state) noexcept;

/// Returns the transition parameter of an adhesive pair, also where its law takes no part in it.
[[nodiscard]] double pairLambda(const ContactModel& model) noexcept;

}  // namespace asperity
