#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/contact/numerics/GaussLegendre.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Number of terms of the profile of a film contact.
inline constexpr std::size_t kFilmProfileTerms = 10;

/// Part of the surface's displacement that the film's base takes away, as polynomials in cells of
/// the distance from the axis over the thickness.
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
    /// Contributions of each wave to the coefficients of the surface, wave by wave.
    std::vector<double> surfaceOfWaves_;
};

/// Contact of a paraboloid with a film in lengths of the thickness t for R = E* = 1: indentations
/// in t^2 / R, forces in E* t^3 / R, energies in E* t^5 / R^2, stiffnesses in E* t.
struct FilmPoint {
    double ratio = 0.0;  ///< contact radius over thickness
    double indentation = 0.0;
    double indentationRate = 0.0;  ///< d indentation / d ratio
    double force = 0.0;
    double stiffness = 0.0;  ///< d force / d indentation
    double energy = 0.0;     ///< integral of the force over the indentation
};

/// Contact radius over thickness up to which the law of a film is held to a reference (T22).
inline constexpr double kMaxFilmContact = 2.0;

/// Contacts with films of one Poisson ratio, tabulated from FilmEquation over the contact radius.
/// The error is measured at build. Beyond the table every quantity goes on as a power of the
/// contact radius, without a step in value or stiffness. Constant after construction; its use
/// neither allocates nor throws. Source: docs/theory.md 2.10.
class FilmTable {
public:
    /// @throw Error as FilmEquation
    explicit FilmTable(const FilmElasticity& elasticity);

    [[nodiscard]] const FilmElasticity& elasticity() const noexcept { return elasticity_; }

    /// Largest relative error of indentation, force, stiffness and energy up to largestRatio().
    [[nodiscard]] double errorBound() const noexcept { return errorBound_; }
    /// Contact radius over thickness up to which the table goes.
    [[nodiscard]] static double largestRatio() noexcept;
    /// Contact radius over thickness from which on a law on a half-space gives at most 1 / 1.05 of
    /// the film's force at the same indentation; infinite where none does.
    [[nodiscard]] double halfSpaceLimit() const noexcept { return halfSpaceLimit_; }

    /// @param ratio contact radius over thickness, >= 0
    [[nodiscard]] FilmPoint at(double ratio) const noexcept;
    /// The point where indentation + compliance x force = value. @param value, compliance >= 0
    [[nodiscard]] FilmPoint onSpring(double value, double compliance) const noexcept;
    /// Pressure over E* a / (pi R), at sqrt(1 - (r / a)^2) = `height`; 2 `height` is Hertz'.
    /// Accurate to 1e-6 up to kMaxFilmContact; beyond the table its shape stays.
    [[nodiscard]] double pressure(double ratio, double height) const noexcept;

    /// Displacement of the surface outside of the contact, sum of both bodies, > 0 into the sample
    /// [t^2 / R]. Accurate to 1e-6 of the indentation up to kMaxFilmContact; far away what an
    /// elastic tip under a point force has, beyond the table its shape stays.
    /// @param distance from the axis over thickness, >= `ratio`; `ratio` > 0
    [[nodiscard]] double displacement(double ratio, double distance) const noexcept;

private:
    static constexpr std::size_t kTerms = 10;  ///< of a polynomial in the ratio
    static constexpr GradedCells kCells{1};    ///< on kNear + ratio
    static constexpr double kNear = 0.5;       ///< up to such a ratio cells are equally wide
    static constexpr double kEnd = 8.0;        ///< of kNear + ratio
    static constexpr std::int64_t kFirst = kCells.cellOf(kNear);
    static constexpr std::int64_t kCount = kCells.cellOf(kEnd) - kFirst;

    /// Coefficients of one power of the position in a cell.
    using Term = FilmRatios;

    struct Position {
        const Term* terms = nullptr;  ///< kTerms of them
        double position = 0.0;        ///< -1 .. 1
        double rate = 0.0;            ///< d position / d ratio
    };

    [[nodiscard]] static FilmRatios valueAt(const Term* terms, double position);
    void fit(const FilmEquation& equation, std::int64_t cell);
    [[nodiscard]] double measure(const FilmEquation& equation, std::int64_t cell) const;
    void findHalfSpaceLimit();
    [[nodiscard]] double displacementWithin(double ratio, double distance) const noexcept;
    using Profile = std::array<double, kFilmProfileTerms>;
    [[nodiscard]] Position positionOf(double ratio) const noexcept;
    [[nodiscard]] static Profile profileAt(const Position& at) noexcept;
    [[nodiscard]] static double surfaceAt(const Position& at, double distance) noexcept;
    [[nodiscard]] FilmPoint within(double ratio) const noexcept;
    [[nodiscard]] FilmPoint beyond(double ratio) const noexcept;

    FilmElasticity elasticity_;
    std::vector<Term> terms_;        ///< by cell and power
    FilmPoint end_;                  ///< of the table
    double indentationPower_ = 2.0;  ///< of the ratio, beyond the end
    double forcePower_ = 3.0;
    double errorBound_ = 0.0;
    double halfSpaceLimit_ = 0.0;
};

/// The table of this elasticity, built once as long as it is in use or among those asked for last:
/// building takes some 50 ms. Any thread. @throw Error as FilmEquation
[[nodiscard]] std::shared_ptr<const FilmTable> sharedFilmTable(const FilmElasticity& elasticity);

/// Elastic contact of a paraboloid with a film bonded to a rigid base, without adhesion or friction
/// under the tip: the exact solution up to a contact radius of FilmTable::largestRatio() film
/// thicknesses, a power of it beyond. Source: docs/theory.md 2.10.
class FilmLaw {
public:
    /// @param thickness of the film [m], > 0
    /// @param table     of the film's Poisson ratio; must outlive the law
    FilmLaw(const ContactPair& pair, double thickness, const FilmTable& table) noexcept;

    // As ContactLaw.h has it; the branch ends where the bodies part.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    double thickness_;        ///< [m]
    double indentationUnit_;  ///< t^2 / R [m]
    double stiffnessUnit_;    ///< E* t [N/m]
    const FilmTable* table_;
};

}  // namespace asperity
