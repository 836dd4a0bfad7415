#pragma once

#include "core/contact/AttractiveTail.h"
#include "core/contact/ContactState.h"
#include "core/contact/Material.h"
#include "core/contact/MaugisDugdale.h"
#include "core/contact/MaugisUnits.h"

namespace asperity {

/// How the work of adhesion is divided between the van der Waals tail and the cohesive zone.
/// Source: docs/physics.md 3.4.
struct AdhesionSplit {
    double hamaker = 0.0;          ///< Hamaker constant of the tail [J]
    double jointSeparation = 0.0;  ///< D_s: the tail acts beyond it, the cohesive zone within [m]
    double cohesiveWork = 0.0;     ///< work of adhesion of the cohesive zone [J/m^2]
    double cohesiveStress = 0.0;   ///< sigma0 [Pa]
    double tailForce = 0.0;        ///< of the tail while bonded, <= 0 [N]
    double tailLift = 0.0;         ///< of the surface by the tail while bonded, >= 0 [m]
    bool tailSnaps = false;        ///< the tail is unstable at the joint: the zone has all of w
};

/// Van der Waals tail joined to Maugis-Dugdale. Before snap-in the tail alone acts; bonded, the
/// cohesive zone acts and the tail is a constant. No allocation after construction.
/// Source: docs/physics.md 3.4, 7.1.
class SplitLaw {
public:
    /// The pair's work of adhesion must be > 0.
    explicit SplitLaw(const ContactPair& pair) noexcept;

    /// As ContactModel::equilibrium().
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           ContactBranch branch) const noexcept;
    /// Approach of the undeflected tip at which the tail snaps in [m].
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept;
    /// Approach of the undeflected tip at which the bond breaks [m].
    [[nodiscard]] double pullOffApproach(double compliance) const noexcept;

    [[nodiscard]] const AdhesionSplit& split() const noexcept { return split_; }
    [[nodiscard]] const AttractiveTail& tail() const noexcept { return tail_; }
    /// Transition parameter of the cohesive zone.
    [[nodiscard]] double lambda() const noexcept { return bonded_.curve().lambda(); }

private:
    [[nodiscard]] MaugisControl control(double compliance) const noexcept;
    [[nodiscard]] double heldValue(double approach, double compliance) const noexcept;
    [[nodiscard]] MaugisPoint bondedAt(double approach, double compliance) const noexcept;
    [[nodiscard]] ContactState farState(double separation) const noexcept;
    [[nodiscard]] ContactState bondedState(const MaugisPoint& point) const noexcept;
    [[nodiscard]] double farEnergy(double separation, double compliance) const noexcept;
    [[nodiscard]] double bondedEnergy(const MaugisPoint& point, double compliance) const noexcept;
    [[nodiscard]] ContactState snapIn(double approach, double compliance,
                                      double end) const noexcept;
    [[nodiscard]] ContactState pullOff(double approach, double compliance) const noexcept;

    AttractiveTail tail_;
    AdhesionSplit split_;
    MaugisUnits units_;
    MaugisDugdale bonded_;
    double jointEnergy_;  ///< of the bonded branch without cohesion [J]
};

}  // namespace asperity
