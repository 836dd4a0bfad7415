#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/Validity.h"

namespace asperity {

/// What a contact law does not hold for at one of its states on a material: large contact, elastic
/// limit, thin film, law out of range (leavesLawsRange()). No allocation.
///
/// The elastic limit is the pressure in the middle at which yield begins, yieldPressure(), by the
/// stated hardness or by an estimate, hardnessOf().
/// A film is thin for laws on a half-space where it makes the contact 5 % stiffer, by the exact
/// solution for the film's Poisson ratio (a/t = 0.042 for 0.5, 0.061 for 0); for `hertz_film` from
/// a/t = 2 on, the end of the reference. Source: docs/theory.md 2.10, 4.4.
[[nodiscard]] ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                                            const SampleMaterial& material) noexcept;

/// Whether a sphere alone is in contact where a tip with the usual shank would touch with that.
[[nodiscard]] bool isBeyondSphere(const ContactModel& model, const ContactState& state) noexcept;

}  // namespace asperity
