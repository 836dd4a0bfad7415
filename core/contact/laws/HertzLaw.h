#pragma once

#include "core/contact/Material.h"
#include "core/contact/laws/LawPoint.h"

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

    // As LawPoint.h has it; the branch ends where the bodies part.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] static double onset() noexcept { return 0.0; }

private:
    double tipRadius_;  ///< [m]
    double factor_;     ///< force over indentation^(3/2) [N / m^(3/2)]
};

}  // namespace asperity
