#pragma once

#include "core/contact/HertzLaw.h"

namespace asperity {

/// Hertz on an incompressible film bonded to a rigid base: Hertz' force times a polynomial in
/// chi = sqrt(R delta) / thickness. No adhesion. From the literature, not derived or verified here.
/// Source: Dimitriadis et al. (2002), as quoted in docs/physics.md 2.10.
class FilmLaw {
public:
    /// @param thickness of the film [m], > 0
    FilmLaw(const ContactPair& pair, double thickness) noexcept;

    /// @param indentation >= 0 [m]
    [[nodiscard]] LawPoint atIndentation(double indentation) const noexcept;

    // As LawPoint.h has it; the branch ends where the bodies part.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    HertzLaw halfSpace_;
    double thickness_;  ///< [m]
};

}  // namespace asperity
