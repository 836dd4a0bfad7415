#pragma once

#include "core/contact/ContactModel.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/Validity.h"

namespace asperity {

/// What a contact law does not hold for at one of its states on a material: large contact, elastic
/// limit, thin film. No allocation. Source: docs/physics.md 2.10, 4.4.
[[nodiscard]] ValidityFlags contactValidity(const ContactModel& model, const ContactState& state,
                                            const SampleMaterial& material) noexcept;

}  // namespace asperity
