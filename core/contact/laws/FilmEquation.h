#pragma once

#include "core/contact/laws/ContactOptions.h"
#include "core/contact/numerics/GradedCells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// Number of terms of the profile of a film contact.
inline constexpr std::size_t kFilmProfileTerms = 10;

/// What the film's base takes from the displacement of the surface, as polynomials in cells of the
/// distance from the axis over the thickness.
struct FilmSurface {
    static constexpr std::size_t kTerms = 8;  ///< of a polynomial
    static constexpr GradedCells kCells{2};   ///< on kNear + distance
    static constexpr double kNear = 0.5;      ///< up to such a distance cells are equally wide
    static constexpr double kEnd = 16.0;      ///< of kNear + distance
    static constexpr std::int64_t kFirst = kCells.cellOf(kNear);
    static constexpr auto kCount = static_cast<std::size_t>(kCells.cellOf(kEnd) - kFirst);
};

/// A contact with a film relative to Hertz' contact of the same radius on a half-space.
struct FilmRatios {
    double indentation = 1.0;  ///< over a^2 / R
    double force = 1.0;        ///< over (4/3) E* a^3 / R
    double stiffness = 1.0;    ///< d force / d indentation over 2 E* a
    double energy = 1.0;       ///< over (8/15) E* a^5 / R^2
    /// phi(x) = a^2 / R times the sum of profile[m] z^(m + 1), z = 1 - (x / a)^2, of which pressure
    /// and force are integrals; 1, 0, 0, ... for Hertz.
    std::array<double, kFilmProfileTerms> profile{1.0};
    /// (pi / 2) displacement, less that of a half-space under the same pressure, over a^3 / (R t):
    /// by cell of FilmSurface and power.
    std::array<double, FilmSurface::kCount * FilmSurface::kTerms> surface{};
};

/// Frictionless contact of a paraboloid with an elastic film that is bonded to a rigid base: the
/// exact solution, as a Fredholm equation of the second kind for the function phi(x) whose Abel
/// transform is the pressure. Allocates; not for the real-time path.
///
/// Film and tip yield to a pressure wave of wave number k / t as (share L(k) + 1 - share) / E*, so
/// that an elastic tip changes nothing but a factor of the kernel.
/// Source: docs/theory.md 2.10.
class FilmEquation {
public:
    /// @throw Error when the Poisson ratio is outside 0 .. 0.5 or the share outside 0 .. 1
    explicit FilmEquation(const FilmElasticity& elasticity);

    /// Accurate to 1e-11 up to a ratio of 8, but for profile and surface (1e-6 up to a ratio of 2).
    /// @param ratio contact radius over the film's thickness, >= 0
    [[nodiscard]] FilmRatios solve(double ratio) const;

private:
    void addSurfaceOf(double number);

    struct Wave {
        double number = 0.0;  ///< k
        double weight = 0.0;  ///< share (L(k) - 1) times the weight of the quadrature
    };
    std::vector<Wave> waves_;
    /// What each wave adds to the coefficients of the surface, wave by wave.
    std::vector<double> surfaceOfWaves_;
};

}  // namespace asperity
