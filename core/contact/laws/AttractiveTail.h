#pragma once

#include "core/Units.h"

#include <algorithm>
#include <optional>

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

/// Tip and sample before snap-in: van der Waals attraction across the separation D of the surfaces,
/// and the lift of the elastic surface under it, to first order. Stable from far away down to one
/// smallest separation. No allocation. Source: docs/theory.md 3.4, equation (3.2).
class AttractiveTail {
public:
    /// @param attraction     between tip and sample
    /// @param reducedModulus E* [Pa]
    /// @param joint          separation where another law takes over [m], > D0
    AttractiveTail(const VanDerWaals& attraction, double reducedModulus, double joint) noexcept;

    [[nodiscard]] const VanDerWaals& attraction() const noexcept { return attraction_; }
    /// Separation below which the attraction outruns the stiffness of the sample itself, D* [m].
    [[nodiscard]] double elasticInstability() const noexcept { return elasticInstability_; }

    /// Lift of the sample's surface under the tip, > 0 towards it [m].
    [[nodiscard]] double lift(double separation) const noexcept;
    /// Approach of the undeformed bodies [m].
    [[nodiscard]] double indentation(double separation) const noexcept;
    /// d(force)/d(indentation), < 0 [N/m]; the separation at least elasticInstability().
    [[nodiscard]] double stiffness(double separation) const noexcept;
    /// Approach of the undeflected tip on a lever of this compliance [m/N].
    [[nodiscard]] double approach(double separation, double compliance) const noexcept;
    /// Work done on the bodies from infinite separation, without the lever's [J].
    [[nodiscard]] double energy(double separation) const noexcept;

    /// Smallest stable separation [m]: an instability of lever and sample, or the joint.
    [[nodiscard]] double endSeparation(double compliance) const noexcept;
    /// Stable separation at an approach [m]; `end` is endSeparation(compliance) and is the answer
    /// where the approach lies beyond it.
    [[nodiscard]] double separationAt(double approach, double compliance,
                                      double end) const noexcept;
    /// The same; none where the approach lies beyond the end. Where the state is clearly stable the
    /// end need not be found, which takes longer.
    [[nodiscard]] std::optional<double> stableSeparation(double approach,
                                                         double compliance) const noexcept;

private:
    /// d(approach)/dD + 1: how much of the stiffness the attraction has used up; 1 is unstable.
    [[nodiscard]] double softening(double separation, double compliance) const noexcept;

    VanDerWaals attraction_;
    double liftFactor_;  ///< lift times separation^(5/2) [m^(7/2)]
    double joint_;
    double elasticInstability_;
};

}  // namespace asperity
