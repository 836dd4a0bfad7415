#pragma once

#include "core/EnumTable.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Model of the attraction between tip and sample in a law.
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

/// One equilibrium of tip and sample on the curve of a contact law, stable or not.
///
/// Every law with one file of its own (HertzLaw, JkrLaw, ...) offers the same four functions, so
/// that ContactModel treats them alike; none of them allocates or throws:
///   LawPoint fold(double compliance) const
///       end of the stable branch on a lever of this compliance [m/N] (0: displacement control);
///   std::optional<LawPoint> stable(double approach, double compliance) const
///       the stable state where approach = indentation + compliance x force [m]; none below fold();
///   double energy(const LawPoint&) const
///       work done on separate bodies to reach the state along the curve [J], without the lever;
///   double onset() const
///       indentation at which separate bodies begin to attract each other [m], <= 0.
struct LawPoint {
    double force = 0.0;           ///< of the sample on the tip, > 0 repulsive [N]
    double indentation = 0.0;     ///< approach of the undeformed bodies, < 0: a gap [m]
    double contactRadius = 0.0;   ///< [m]
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone, >= contactRadius [m]
    double stiffness = 0.0;       ///< d(force)/d(indentation) along the curve [N/m]
    double coordinate = 0.0;      ///< on the curve, where a law can start from it; 0: none
};

/// Slope of a curve from its rates; the largest double where the curve is vertical.
[[nodiscard]] inline double curveStiffness(double forceRate, double indentationRate) noexcept {
    constexpr double kMax = std::numeric_limits<double>::max();
    if (std::abs(indentationRate) <= std::abs(forceRate) / kMax) {
        return std::copysign(kMax, forceRate);
    }
    return forceRate / indentationRate;
}

}  // namespace asperity
