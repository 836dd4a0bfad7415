#pragma once

#include "core/Units.h"

#include <algorithm>

namespace asperity {

/// Separation at which two solids are taken to touch, D0 [m]. Source: docs/theory.md 3.1.
inline constexpr double kContactSeparation = units::operator""_pm(165ULL);

/// Non-retarded van der Waals attraction of a sphere and a half-space; separations below D0 count
/// as D0. Source: Hamaker (1937); docs/theory.md 3.1.
class VanDerWaals {
public:
    /// @param hamaker Hamaker constant [J]  @param radius of the sphere [m], > 0
    VanDerWaals(double hamaker, double radius) noexcept : hamaker_(hamaker), radius_(radius) {}

    [[nodiscard]] double hamaker() const noexcept { return hamaker_; }  ///< [J]
    [[nodiscard]] double radius() const noexcept { return radius_; }    ///< [m]

    /// < 0: attraction [N]
    [[nodiscard]] double force(double separation) const noexcept {
        const double d = std::max(separation, kContactSeparation);
        const double ratio = radius_ / (d * (d + (2.0 * radius_)));
        return -2.0 / 3.0 * hamaker_ * radius_ * ratio * ratio;
    }
    /// dF/dD > 0 [N/m]
    [[nodiscard]] double gradient(double separation) const noexcept {
        const double d = std::max(separation, kContactSeparation);
        return -2.0 * force(d) * (1.0 / d + 1.0 / (d + (2.0 * radius_)));
    }
    [[nodiscard]] double energy(double separation) const noexcept;  ///< 0 far away [J]
    /// Separation [m] at which the force takes this value, < 0 [N].
    [[nodiscard]] double separationAt(double force) const noexcept;

private:
    double hamaker_;
    double radius_;
};

/// Hamaker constant [J] of the cut-off attraction that takes the work of adhesion w [J/m^2] to part
/// two half-spaces from D0, H = 12 pi w D0^2. Source: docs/theory.md 3.3.
[[nodiscard]] double hamakerConstant(double workOfAdhesion) noexcept;

/// Wavelength of the electronic absorption that mediates van der Waals attraction [m]. A property
/// of matter, about the same for all solids and no limit of the program. Source: Gregory (1981).
inline constexpr double kAbsorptionWavelength = units::operator""_nm(100ULL);

/// Share of the attraction between a sphere and a half-space that is lost because light takes its
/// time across the separation D [m]: x / (1 + x), x = 5.32 D / lambda, by Derjaguin's approximation
/// from the energy of two half-spaces. Source: Gregory, J. Colloid Interface Sci. 83 (1981) 138;
/// docs/theory.md 3.7.
[[nodiscard]] constexpr double retardedShare(double separation) noexcept {
    const double delay = 5.32 * separation / kAbsorptionWavelength;
    return delay / (1.0 + delay);
}

}  // namespace asperity
