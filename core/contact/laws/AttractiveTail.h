#pragma once

#include "core/contact/laws/VanDerWaals.h"

#include <optional>

namespace asperity {

/// Tip and sample before snap-in: van der Waals attraction across the separation D of the surfaces,
/// and the lift of the elastic surface under it, to first order. Stable from far away down to one
/// smallest separation. No allocation. Source: docs/theory.md 3.4, equation (3.2).
class AttractiveTail {
public:
    /// @param attraction     between tip and sample
    /// @param reducedModulus E* [Pa]
    /// @param joint          separation where another law takes over [m], > D0
    AttractiveTail(const VanDerWaals& attraction, double reducedModulus, double joint) noexcept;

    [[nodiscard]] const VanDerWaals& attraction() const noexcept { return attraction_; }
    /// Separation below which the attraction outruns the stiffness of the sample itself, D* [m].
    [[nodiscard]] double elasticInstability() const noexcept { return elasticInstability_; }

    /// Lift of the sample's surface under the tip, > 0 towards it [m].
    [[nodiscard]] double lift(double separation) const noexcept;
    /// Approach of the undeformed bodies [m].
    [[nodiscard]] double indentation(double separation) const noexcept;
    /// d(force)/d(indentation), < 0 [N/m]; the separation at least elasticInstability().
    [[nodiscard]] double stiffness(double separation) const noexcept;
    /// Approach of the undeflected tip on a lever of this compliance [m/N].
    [[nodiscard]] double approach(double separation, double compliance) const noexcept;
    /// Work done on the bodies from infinite separation, without the lever's [J].
    [[nodiscard]] double energy(double separation) const noexcept;

    /// Smallest stable separation [m]: an instability of lever and sample, or the joint.
    [[nodiscard]] double endSeparation(double compliance) const noexcept;
    /// Stable separation at an approach [m]; `end` is endSeparation(compliance) and is the answer
    /// where the approach lies beyond it.
    [[nodiscard]] double separationAt(double approach, double compliance,
                                      double end) const noexcept;
    /// The same; none where the approach lies beyond the end. Where the state is clearly stable the
    /// end need not be found, which takes longer.
    [[nodiscard]] std::optional<double> stableSeparation(double approach,
                                                         double compliance) const noexcept;

private:
    /// d(approach)/dD + 1: how much of the stiffness the attraction has used up; 1 is unstable.
    [[nodiscard]] double softening(double separation, double compliance) const noexcept;

    VanDerWaals attraction_;
    double liftFactor_;  ///< lift times separation^(5/2) [m^(7/2)]
    double joint_;
    double elasticInstability_;
};

}  // namespace asperity
