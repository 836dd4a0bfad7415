#pragma once

#include "core/contact/laws/HertzLaw.h"

namespace asperity {

/// Adhesion of a stiff, small tip in Maugis' form: Hertz' profile under a constant attraction
/// -2 pi w R from outside the contact, which has no range. Exact for a transition parameter of 0;
/// pull-off within 1 % below 0.05.
/// Source: Derjaguin, Muller, Toporov (1975); Maugis (1992); docs/theory.md 2.1, 2.9.
class DmtLaw {
public:
    explicit DmtLaw(const ContactPair& pair) noexcept;

    [[nodiscard]] LawPoint atContactRadius(double contactRadius) const noexcept;
    /// @param force at least that of pull-off, -2 pi w R [N]
    [[nodiscard]] LawPoint atForce(double force) const noexcept;
    [[nodiscard]] LawPoint atIndentation(double indentation) const noexcept;

    // As LawPoint.h has it; the branch ends where the bodies part, at pull-off in any control.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    [[nodiscard]] LawPoint attracted(LawPoint point) const noexcept;

    HertzLaw elastic_;
    double attraction_;  ///< 2 pi w R [N]
};

}  // namespace asperity
