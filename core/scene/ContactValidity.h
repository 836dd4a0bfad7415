#pragma once

#include "core/contact/ContactModel.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/Validity.h"

namespace asperity {

/// What a contact law does not hold for at one of its states on a material: large contact, elastic
/// limit, thin film, law out of range (leavesLawsRange()). No allocation.
///
/// A film is thin for laws on a half-space where it stiffens the contact by 4 %, a/t = 0.035; for
/// `hertz_film`, whose series is one around a/t = 0, from a/t = 1 on.
/// Source: docs/physics.md 2.10 (Dimitriadis), 4.4.
[[nodiscard]] ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                                            const SampleMaterial& material) noexcept;

}  // namespace asperity
