#pragma once

#include "core/contact/Material.h"
#include "core/contact/laws/ContactLaw.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// Returns whether a contact is too wide for linear elasticity to be credible, above 0.3 of the
/// effective radius of tip and sample, whichever law. Source: docs/theory.md 2.10.
[[nodiscard]] bool isLargeContact(double contactRadius, double effectiveRadius) noexcept;

/// Why a contact law was taken.
enum class LawReason : std::uint8_t {
    AskedFor,
    TermsOfScene,  ///< of the force, on which the scene decides one by one
    NoAdhesion,
    FilmWithoutAdhesion,
    NoAdhesionCone,  ///< and a tip whose cone the load may press in
    NarrowContact,   ///< without load: the paraboloid holds
    WideContact,     ///< without load: only the exact sphere does
};

/// A contact law and why it was taken.
struct LawChoice {
    ContactLaw law = ContactLaw::Split;
    LawReason reason = LawReason::AskedFor;
    double unloadedRatio = 0.0;  ///< contact radius over tip radius, where the width decided
};

/// The law that was asked for, or where none was (`auto`): Maugis-Dugdale, which is exact from DMT
/// to JKR, with its van der Waals tail; the same on the exact sphere where the contact is wider
/// than 0.3 R already without load. Without adhesion Hertz, on a film that of the film; Sneddon's
/// under a tip with a cone, since a paraboloid has none. Source:
/// docs/theory.md 2.9, 2.10, 4.4, 4.8.
/// @param filmThickness of the sample [m]; 0: a half-space
/// @param coneHalfAngle of the tip [rad]; 0: no cone
/// @throw Error where none was asked for and the pair is outside the laws' range, see ContactStatus
[[nodiscard]] LawChoice chooseLaw(std::optional<ContactLaw> wanted, const ContactPair& pair,
                                  double filmThickness = 0.0, double coneHalfAngle = 0.0);

}  // namespace asperity
