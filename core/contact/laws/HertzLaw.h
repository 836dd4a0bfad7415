#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/TipPunch.h"
#include "core/contact/numerics/RootSearch.h"

#include <optional>

namespace asperity {

/// Elastic contact of a paraboloid without adhesion: P = (4/3) E* sqrt(R) delta^(3/2), a^2 = R
/// delta. Valid for contact radii below about 0.3 R. Source: Hertz (1882);
/// docs/theory.md 2.1, 2.7.
class HertzLaw {
public:
    explicit HertzLaw(const ContactPair& pair) noexcept;

    /// @param contactRadius >= 0 [m]
    [[nodiscard]] LawPoint atContactRadius(double contactRadius) const noexcept;
    /// @param force >= 0 [N]
    [[nodiscard]] LawPoint atForce(double force) const noexcept;
    /// @param indentation >= 0 [m]
    [[nodiscard]] LawPoint atIndentation(double indentation) const noexcept;

    // As ContactLaw.h has it; the branch ends where the bodies part.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    double tipRadius_;  ///< [m]
    double factor_;     ///< force over indentation^(3/2) [N / m^(3/2)]
};

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

    // As ContactLaw.h has it; the branch ends where the bodies part, at pull-off in any control.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    [[nodiscard]] LawPoint attracted(LawPoint point) const noexcept;

    HertzLaw elastic_;
    double attraction_;  ///< 2 pi w R [N]
};

/// A sphere on a half-space without adhesion, Hertz beyond the paraboloid: up to the equator, or
/// with a cone that goes on from it. The work of adhesion of the pair is ignored. The four
/// functions of ContactLaw.h; real-time safe. Source: Sneddon (1965); docs/theory.md 4.4, 4.8.
class SneddonLaw {
public:
    /// @param coneHalfAngle of the cone that goes on from the sphere [rad]; 0: none
    explicit SneddonLaw(const ContactPair& pair, double coneHalfAngle = 0.0) noexcept
        : units_(pair), punch_(coneHalfAngle) {}

    /// The state with this contact radius; without a cone up to the tip radius [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;

    [[nodiscard]] static LawPoint fold(double compliance) noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    [[nodiscard]] LawPoint pointAt(const PunchContact& contact) const noexcept;
    [[nodiscard]] Rise approachAt(const PunchContact& contact, double compliance) const noexcept;

    SphereUnits units_;
    TipPunch punch_;
};

/// Pressure in the middle of an elastic contact at which a sample of this hardness begins to yield
/// below the surface, long before it flows [Pa].
///
/// On the axis of Hertz' contact, at depth z = x a, the two principal stresses differ by p0 f(x),
/// f = 3 / (2 (1 + x^2)) - (1 + nu) (1 - x atan(1/x)), and by nothing else in Tresca's or von
/// Mises' condition: yield begins at p0 = Y / max f, 1.30 Y at nu = 0, 1.61 Y at 0.3 and 1.88 Y at
/// 0.5. A hardness is the mean pressure under a fully plastic contact, H = 2.8 Y; so the onset lies
/// between 0.46 H and 0.67 H.
///
/// An adhesive contact's pressure is that of Hertz less tractions of the flat punch's kind, each
/// p / sqrt(1 - r^2/t^2) with its own radius t. Under one of radius a the stresses differ by
/// p (f - x f'), where f is largest by p f: there they are in the same ratio to the pressure in the
/// middle as under Hertz' alone, singular edge or not. The largest difference lies a little higher;
/// it is 7 % more for JKR without load, and less under load. The onset is known no better than
/// hardness over yield stress, 2.6 to 3.
///
/// Sources: Johnson, Contact Mechanics (1985), chapter 6 (onset of yield, hardness; Tabor 1951);
/// the closed form 1.295 exp(0.736 nu) of 1 / max f: Jackson, Green (2005), within 0.4 %.
/// @param hardness     [Pa], >= 0  @param poissonRatio of the sample, 0 .. 0.5
[[nodiscard]] double yieldPressure(double hardness, double poissonRatio) noexcept;

}  // namespace asperity
