#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace asperity {

/// The normal contact laws, each by its own class.
enum class ContactLaw : std::uint8_t {
    Hertz,         ///< elastic, no adhesion
    Dmt,           ///< adhesion of stiff, small tips
    Jkr,           ///< adhesion of soft, large tips
    Maugis,        ///< Maugis-Dugdale, from one to the other
    Sneddon,       ///< Hertz on the exact sphere
    SphereJkr,     ///< JKR on the exact sphere
    SphereMaugis,  ///< Maugis-Dugdale on the exact sphere
    Split,         ///< van der Waals tail joined to Maugis-Dugdale
    SphereSplit,   ///< the same on the exact sphere
    HertzFilm,     ///< Hertz on a bonded incompressible film
};

inline constexpr std::array kContactLaws{
    ContactLaw::Hertz,       ContactLaw::Dmt,       ContactLaw::Jkr,          ContactLaw::Maugis,
    ContactLaw::Sneddon,     ContactLaw::SphereJkr, ContactLaw::SphereMaugis, ContactLaw::Split,
    ContactLaw::SphereSplit, ContactLaw::HertzFilm};

/// Whether the law takes the tip as an exact sphere, not as the paraboloid that osculates it.
[[nodiscard]] bool isSphere(ContactLaw law) noexcept;

/// Whether the law has a van der Waals tail before contact.
[[nodiscard]] bool hasTail(ContactLaw law) noexcept;

/// Whether the law's attraction acts inside the contact only, with a neck at its edge.
[[nodiscard]] bool isJkr(ContactLaw law) noexcept;

/// As scenes and tables call it: "hertz", "md_sphere".
[[nodiscard]] const char* keyOf(ContactLaw law) noexcept;

/// The law of that name; none where it is no law's.
[[nodiscard]] std::optional<ContactLaw> lawFromKey(std::string_view key) noexcept;

/// For people: "Hertz", "Maugis-Dugdale on the exact sphere".
[[nodiscard]] const char* nameOf(ContactLaw law) noexcept;

}  // namespace asperity
