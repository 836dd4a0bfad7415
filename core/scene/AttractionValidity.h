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
/// Limited by strength: a JKR reading of pull-off, w = 2 F / (3 pi R), would be wrong by more than
/// a twentieth. It is where the tip is pulled by more than 1.05 times JKR's 1.5 pi w R, a meniscus
/// taken off: lambda is below 1.23 then, and more than half of the interface's strength pulls at
/// pull-off. And it is after a preload under which the sample yields, if the contact is so small
/// that, left flat, it parts with its full strength all over: that pull-off grows with the preload.
/// @param compliance of the lever along the normal [m/N]
/// @param yields     the sample yields in this state: flag ElasticLimit of contactValidity()
/// Source: docs/theory.md 2.5, 2.11, 3.7.
[[nodiscard]] ValidityFlags attractionValidity(const ContactModel& model, const ContactState& state,
                                               double compliance, bool yields) noexcept;

}  // namespace asperity
