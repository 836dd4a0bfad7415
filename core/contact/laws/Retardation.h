#pragma once

#include "core/Units.h"

namespace asperity {

/// Wavelength of the electronic absorption that mediates van der Waals attraction [m]. A property
/// of matter, about the same for all solids and no limit of the program. Source: Gregory (1981).
inline constexpr double kAbsorptionWavelength = units::operator""_nm(100ULL);

/// Share of the non-retarded attraction between a sphere and a half-space that is lost because
/// light takes its time across the separation D [m]: x / (1 + x), x = 5.32 D / lambda, by
/// Derjaguin's approximation from the energy of two half-spaces. Source: Gregory, J. Colloid
/// Interface Sci. 83 (1981) 138; docs/theory.md 3.7.
[[nodiscard]] constexpr double retardedShare(double separation) noexcept {
    const double delay = 5.32 * separation / kAbsorptionWavelength;
    return delay / (1.0 + delay);
}

}  // namespace asperity
