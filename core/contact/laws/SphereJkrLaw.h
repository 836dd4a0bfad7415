#pragma once

#include "core/contact/laws/LawPoint.h"
#include "core/contact/laws/SpherePunch.h"

#include <optional>

namespace asperity {

/// A sphere on a half-space with adhesion of no range, up to the equator: JKR beyond the
/// paraboloid. The four functions of LawPoint.h; real-time safe.
/// Source: Maugis (1995); docs/theory.md 4.4.
class SphereJkrLaw {
public:
    explicit SphereJkrLaw(const ContactPair& pair) noexcept;

    /// The state with this contact radius, 0 .. tip radius, stable or not [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;

    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    struct Rates;

    [[nodiscard]] LawPoint pointAt(const SphereContact& contact) const noexcept;
    [[nodiscard]] Rates ratesAt(const SphereContact& contact) const noexcept;
    [[nodiscard]] double foldDepth(double softness) const noexcept;

    SphereUnits units_;
    double adhesion_;                ///< w / (E* R)
    double pull_;                    ///< sqrt(2 pi w / (E* R))
    double displacementFold_ = 0.0;  ///< depth of the fold on a rigid lever
    double loadFold_ = 0.0;          ///< depth of the smallest force
};

}  // namespace asperity
