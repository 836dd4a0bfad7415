#pragma once

#include "core/contact/Material.h"
#include "core/contact/laws/FilmTable.h"
#include "core/contact/laws/LawPoint.h"

#include <optional>

namespace asperity {

/// Elastic contact of a paraboloid with a film bonded to a rigid base, without adhesion or friction
/// under the tip: the exact solution up to a contact radius of FilmTable::largestRatio() film
/// thicknesses, a power of it beyond. Source: docs/theory.md 2.10.
class FilmLaw {
public:
    /// @param thickness of the film [m], > 0
    /// @param table     of the film's Poisson ratio; must outlive the law
    FilmLaw(const ContactPair& pair, double thickness, const FilmTable& table) noexcept;

    // As LawPoint.h has it; the branch ends where the bodies part.
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
