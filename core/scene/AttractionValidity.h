#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/scene/Validity.h"

namespace asperity {

/// Returns whether attraction across a gap moves a tip on its lever by more than a twentieth of the
/// separation: where not, retardation does not matter. @param compliance along the normal [m/N]
[[nodiscard]] bool isPulledByFar(const ContactState& state, double compliance) noexcept;

/// Returns what a law's attraction does not hold for at one of its states: retardation, which the
/// tail neglects, and adhesion that is limited by strength. No allocation.
///
/// Retarded: the tail's lost share would let the lever move the tip by more than a twentieth of the
/// separation.
///
/// Limited by strength: the tip is pulled by more than pi w R, so that pull-off is near, and the
/// transition parameter lies below 0.425, where the pull-off force is nearer to 2 pi w R than to
/// JKR's 1.5 pi w R. Then most of the zone pulls with its full strength at pull-off (0.87 of it on
/// average, and more below), and JKR reads w too high by 17 to 33 %.
/// @param compliance of the lever along the normal [m/N]
/// Source: docs/theory.md 2.5, 2.11, 3.7.
[[nodiscard]] ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                               double compliance) noexcept;

}  // namespace asperity
