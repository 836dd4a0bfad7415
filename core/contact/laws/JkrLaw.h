#pragma once

#include "core/contact/Material.h"
#include "core/contact/laws/LawPoint.h"
#include "core/contact/maugis/MaugisUnits.h"

#include <optional>

namespace asperity {

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

    // As LawPoint.h has it.
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
