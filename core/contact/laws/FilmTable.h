#pragma once

#include "core/contact/laws/FilmEquation.h"
#include "core/contact/numerics/GradedCells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace asperity {

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

    /// Coefficients of one power of the place in a cell.
    using Term = FilmRatios;

    struct Place {
        const Term* terms = nullptr;  ///< kTerms of them
        double place = 0.0;           ///< -1 .. 1
        double rate = 0.0;            ///< d place / d ratio
    };

    [[nodiscard]] static FilmRatios valueAt(const Term* terms, double place);
    void fit(const FilmEquation& equation, std::int64_t cell);
    [[nodiscard]] double measure(const FilmEquation& equation, std::int64_t cell) const;
    void findHalfSpaceLimit();
    [[nodiscard]] double displacementWithin(double ratio, double distance) const noexcept;
    using Profile = std::array<double, kFilmProfileTerms>;
    [[nodiscard]] Place placeOf(double ratio) const noexcept;
    [[nodiscard]] static Profile profileAt(const Place& at) noexcept;
    [[nodiscard]] static double surfaceAt(const Place& at, double distance) noexcept;
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

}  // namespace asperity
