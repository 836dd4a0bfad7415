#pragma once

#include "core/contact/laws/LawPoint.h"
#include "core/contact/laws/TipPunch.h"

#include <limits>
#include <optional>

namespace asperity {

struct Rise;

/// A sphere on a half-space with adhesion of no range, JKR beyond the paraboloid: up to the
/// equator, or with a cone that goes on from it. The four functions of LawPoint.h; real-time safe.
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

}  // namespace asperity
