#pragma once

#include "core/contact/laws/LawPoint.h"
#include "core/contact/laws/TipPunch.h"
#include "core/contact/numerics/RisingSearch.h"

#include <optional>

namespace asperity {

/// A sphere on a half-space without adhesion, Hertz beyond the paraboloid: up to the equator, or
/// with a cone that goes on from it. The work of adhesion of the pair is ignored. The four
/// functions of LawPoint.h; real-time safe. Source: Sneddon (1965); docs/theory.md 4.4, 4.8.
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

}  // namespace asperity
