#pragma once

#include <array>
#include <cstddef>
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

/// How a law takes attraction between tip and sample.
enum class Attraction : std::uint8_t {
    None,
    Outside,  ///< around the contact only (DMT)
    Inside,   ///< inside the contact only, with a neck at its edge (JKR)
    Zone,     ///< a cohesive zone of finite range (Maugis-Dugdale)
};

/// All there is to say of a law; scene files, tables, reports and choices go by this.
struct LawTraits {
    ContactLaw law;
    const char* key;   ///< in scenes and tables
    const char* name;  ///< for people
    Attraction attraction = Attraction::None;
    bool sphere = false;  ///< the tip is an exact sphere, not the paraboloid that osculates it
    bool tail = false;    ///< van der Waals attraction before contact
    bool film = false;    ///< the sample is a film on a rigid base
    bool table = false;   ///< it may be looked up in MaugisTable, see SolverTier
};

/// In the order of ContactLaw.
inline constexpr std::array kLawTraits{
    LawTraits{.law = ContactLaw::Hertz, .key = "hertz", .name = "Hertz"},
    LawTraits{
        .law = ContactLaw::Dmt, .key = "dmt", .name = "DMT", .attraction = Attraction::Outside},
    LawTraits{
        .law = ContactLaw::Jkr, .key = "jkr", .name = "JKR", .attraction = Attraction::Inside},
    LawTraits{.law = ContactLaw::Maugis,
              .key = "md",
              .name = "Maugis-Dugdale",
              .attraction = Attraction::Zone,
              .table = true},
    LawTraits{
        .law = ContactLaw::Sneddon, .key = "sneddon", .name = "Sneddon's sphere", .sphere = true},
    LawTraits{.law = ContactLaw::SphereJkr,
              .key = "jkr_sphere",
              .name = "JKR on the exact sphere",
              .attraction = Attraction::Inside,
              .sphere = true},
    LawTraits{.law = ContactLaw::SphereMaugis,
              .key = "md_sphere",
              .name = "Maugis-Dugdale on the exact sphere",
              .attraction = Attraction::Zone,
              .sphere = true},
    LawTraits{.law = ContactLaw::Split,
              .key = "split",
              .name = "Maugis-Dugdale with tail",
              .attraction = Attraction::Zone,
              .tail = true,
              .table = true},
    LawTraits{.law = ContactLaw::SphereSplit,
              .key = "split_sphere",
              .name = "Maugis-Dugdale with tail on the exact sphere",
              .attraction = Attraction::Zone,
              .sphere = true,
              .tail = true},
    LawTraits{.law = ContactLaw::HertzFilm,
              .key = "hertz_film",
              .name = "Hertz on a film",
              .film = true}};

inline constexpr auto kContactLaws = [] {
    std::array<ContactLaw, kLawTraits.size()> laws{};
    for (std::size_t i = 0; i < laws.size(); ++i) {
        laws[i] = kLawTraits[i].law;
    }
    return laws;
}();

[[nodiscard]] constexpr const LawTraits& traitsOf(ContactLaw law) noexcept {
    return kLawTraits[static_cast<std::size_t>(law)];
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

/// As scenes and tables call it: "hertz", "md_sphere".
[[nodiscard]] constexpr const char* keyOf(ContactLaw law) noexcept { return traitsOf(law).key; }
/// For people: "Hertz", "Maugis-Dugdale on the exact sphere".
[[nodiscard]] constexpr const char* nameOf(ContactLaw law) noexcept { return traitsOf(law).name; }

/// The law of that key; none where it is no law's.
[[nodiscard]] std::optional<ContactLaw> lawFromKey(std::string_view key) noexcept;

/// The law that differs from this one by these two traits alone; none where there is no such law.
[[nodiscard]] std::optional<ContactLaw> lawLike(ContactLaw law, bool sphere, bool tail) noexcept;

}  // namespace asperity
