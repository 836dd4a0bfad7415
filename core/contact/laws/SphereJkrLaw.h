#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/TipPunch.h"
#include "core/contact/maugis/MaugisDugdale.h"

#include <limits>
#include <optional>

namespace asperity {

struct Rise;

/// A sphere on a half-space with adhesion of no range, JKR beyond the paraboloid: up to the
/// equator, or with a cone that goes on from it. The four functions of ContactLaw.h; real-time
/// safe.
///
/// A slender cone begins with a dip: strong adhesion leaves two stretches of stable states there,
/// with the contact's edge on the sphere and on the cone. Which of them a tip is on then follows
/// from the coordinate of the state before; one that has none touches from the apex on.
/// Source: Maugis (1995); docs/theory.md 4.4, 4.8.
class SphereJkrLaw {
public:
    /// @param coneHalfAngle of the cone that goes on from the sphere [rad]; 0: none
    explicit SphereJkrLaw(const ContactPair& pair, double coneHalfAngle = 0.0) noexcept;

    /// The state with this contact radius, stable or not; without a cone up to the tip radius [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;

    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate = 0.0) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    struct Rates;

    /// Coordinates at the ends of the stable states: from `inner` to `crest` and from `outer` on.
    struct Stretches {
        double inner = 0.0;
        double crest = std::numeric_limits<double>::infinity();
        double outer = std::numeric_limits<double>::infinity();

        [[nodiscard]] bool areTwo() const noexcept { return crest < outer; }
    };

    [[nodiscard]] LawPoint pointAt(const PunchContact& contact) const noexcept;
    [[nodiscard]] LawPoint inSi(const PunchContact& contact) const noexcept;
    [[nodiscard]] Rates ratesAt(const PunchContact& contact) const noexcept;
    [[nodiscard]] double heldRate(double coordinate, double softness) const noexcept;
    [[nodiscard]] Rise heldAt(double coordinate, double softness) const noexcept;
    void findFolds() noexcept;
    [[nodiscard]] double dipOf(double softness) const noexcept;
    [[nodiscard]] double rootBeyond(double coordinate, double softness) const noexcept;
    [[nodiscard]] Stretches stretches(double softness) const noexcept;
    [[nodiscard]] LawPoint climb(double target, double softness, double from,
                                 double to) const noexcept;

    SphereUnits units_;
    TipPunch punch_;
    double adhesion_;                ///< w / (E* R)
    double pull_;                    ///< sqrt(2 pi w / (E* R))
    bool mayDip_ = false;            ///< whether a lever may leave two stretches of stable states
    double displacementFold_ = 0.0;  ///< coordinate of the fold on a rigid lever, unless mayDip_
    double loadFold_ = 0.0;          ///< of the smallest force, unless mayDip_
};

/// Adhesion of a soft, large tip: attraction inside the contact only, with a neck at its edge.
/// Exact for an infinite transition parameter; pull-off within 1 % above 3.2.
/// The pair's work of adhesion must be > 0.
/// Source: Johnson, Kendall, Roberts (1971); docs/theory.md 2.1, 2.9.
class JkrLaw {
public:
    explicit JkrLaw(const ContactPair& pair) noexcept;

    /// Stable or not. @param contactRadius >= 0 [m]
    [[nodiscard]] LawPoint atContactRadius(double contactRadius) const noexcept;
    /// Stable in load control; none below pull-off.
    [[nodiscard]] std::optional<LawPoint> atForce(double force) const noexcept;
    /// The other state at this force, with the smaller contact; none below pull-off or above 0.
    [[nodiscard]] std::optional<LawPoint> unstableAtForce(double force) const noexcept;
    /// Stable in displacement control; none below jump-off.
    [[nodiscard]] std::optional<LawPoint> atIndentation(double indentation) const noexcept;
    /// The other state at this indentation; none below jump-off or above 0.
    [[nodiscard]] std::optional<LawPoint> unstableAtIndentation(double indentation) const noexcept;

    // As ContactLaw.h has it.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    /// @param root square root of the contact radius, in Maugis' units
    [[nodiscard]] LawPoint atRoot(double root) const noexcept;

    MaugisUnits units_;
};

}  // namespace asperity
