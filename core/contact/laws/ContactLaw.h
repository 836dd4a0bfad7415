#pragma once

#include "core/EnumTable.h"

#include <cstddef>
#include <cstdint>
#include <optional>

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

/// How a law takes attraction between tip and sample.
enum class Attraction : std::uint8_t {
    None,
    Outside,  ///< around the contact only (DMT)
    Inside,   ///< inside the contact only, with a neck at its edge (JKR)
    Zone,     ///< a cohesive zone of finite range (Maugis-Dugdale)
};

/// Traits of a law; scene files, tables, reports and choices go by this.
struct LawTraits {
    ContactLaw value;
    const char* key;   ///< in scenes and tables
    const char* name;  ///< for people
    Attraction attraction = Attraction::None;
    bool sphere = false;  ///< the tip is exact, sphere or sphere and cone, not its paraboloid
    bool tail = false;    ///< van der Waals attraction before contact
    bool film = false;    ///< the sample is a film on a rigid base
    bool table = false;   ///< it may be looked up in MaugisTable, see SolverSetting
};

/// In the order of ContactLaw.
template <>
inline constexpr auto kEnumTable<ContactLaw> = std::to_array<LawTraits>(
    {{.value = ContactLaw::Hertz, .key = "hertz", .name = "Hertz"},
     {.value = ContactLaw::Dmt, .key = "dmt", .name = "DMT", .attraction = Attraction::Outside},
     {.value = ContactLaw::Jkr, .key = "jkr", .name = "JKR", .attraction = Attraction::Inside},
     {.value = ContactLaw::Maugis,
      .key = "md",
      .name = "Maugis-Dugdale",
      .attraction = Attraction::Zone,
      .table = true},
     {.value = ContactLaw::Sneddon, .key = "sneddon", .name = "Sneddon's sphere", .sphere = true},
     {.value = ContactLaw::SphereJkr,
      .key = "jkr_sphere",
      .name = "JKR on the exact sphere",
      .attraction = Attraction::Inside,
      .sphere = true},
     {.value = ContactLaw::SphereMaugis,
      .key = "md_sphere",
      .name = "Maugis-Dugdale on the exact sphere",
      .attraction = Attraction::Zone,
      .sphere = true},
     {.value = ContactLaw::Split,
      .key = "split",
      .name = "Maugis-Dugdale with tail",
      .attraction = Attraction::Zone,
      .tail = true,
      .table = true},
     {.value = ContactLaw::SphereSplit,
      .key = "split_sphere",
      .name = "Maugis-Dugdale with tail on the exact sphere",
      .attraction = Attraction::Zone,
      .sphere = true,
      .tail = true},
     {.value = ContactLaw::HertzFilm,
      .key = "hertz_film",
      .name = "Hertz on a film",
      .film = true}});

[[nodiscard]] constexpr const LawTraits& traitsOf(ContactLaw law) noexcept {
    return kEnumTable<ContactLaw>[static_cast<std::size_t>(law)];
}

[[nodiscard]] constexpr bool isSphere(ContactLaw law) noexcept { return traitsOf(law).sphere; }
[[nodiscard]] constexpr bool hasTail(ContactLaw law) noexcept { return traitsOf(law).tail; }
[[nodiscard]] constexpr bool isFilm(ContactLaw law) noexcept { return traitsOf(law).film; }
[[nodiscard]] constexpr bool isAdhesive(ContactLaw law) noexcept {
    return traitsOf(law).attraction != Attraction::None;
}
[[nodiscard]] constexpr bool isJkr(ContactLaw law) noexcept {
    return traitsOf(law).attraction == Attraction::Inside;
}

/// Returns whether the law takes the tip for its paraboloid, so that a cone above the sphere makes
/// no difference to it.
[[nodiscard]] constexpr bool leavesOutCone(ContactLaw law) noexcept { return !isSphere(law); }

/// The law that differs from this one by these two traits alone; none where there is no such law.
[[nodiscard]] std::optional<ContactLaw> lawLike(ContactLaw law, bool sphere, bool tail) noexcept;

}  // namespace asperity
