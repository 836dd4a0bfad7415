#pragma once

#include "core/contact/laws/LawPoint.h"
#include "core/contact/laws/SpherePunch.h"

#include <optional>

namespace asperity {

/// A sphere on a half-space without adhesion: Hertz beyond the paraboloid, up to the equator.
/// The work of adhesion of the pair is ignored. The four functions of LawPoint.h; real-time safe.
/// Source: Sneddon (1965); docs/theory.md 4.4.
class SneddonLaw {
public:
    explicit SneddonLaw(const ContactPair& pair) noexcept : units_(pair) {}

    /// The state with this contact radius, 0 .. tip radius [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;

    [[nodiscard]] static LawPoint fold(double compliance) noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    SphereUnits units_;
};

}  // namespace asperity
