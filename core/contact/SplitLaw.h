#pragma once

#include "core/contact/AttractiveTail.h"
#include "core/contact/LawPoint.h"
#include "core/contact/Material.h"
#include "core/contact/MaugisLaw.h"

#include <optional>

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

/// The tail of a pair with work of adhesion > 0, down to where the cohesive zone takes over.
[[nodiscard]] AttractiveTail splitTail(const ContactPair& pair) noexcept;

/// The bonded side of the split van der Waals and Maugis-Dugdale model: the cohesive zone acts, and
/// what the tail does outside of it is a constant force and lift. Before it acts splitTail().
/// Source: docs/physics.md 3.4, equation (3.3).
class SplitLaw {
public:
    /// The pair's work of adhesion must be > 0. @param tail splitTail() of the pair
    SplitLaw(const ContactPair& pair, const AttractiveTail& tail,
             MaugisSolver solver = {}) noexcept;

    [[nodiscard]] const AdhesionSplit& split() const noexcept { return split_; }
    [[nodiscard]] double cohesiveStress() const noexcept { return split_.cohesiveStress; }
    /// Transition parameter of the cohesive zone.
    [[nodiscard]] double lambda() const noexcept { return zone_.lambda(); }

    // As LawPoint.h has it; the energy is counted from infinite separation.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;

private:
    [[nodiscard]] double approachOfZone(double approach, double compliance) const noexcept;
    [[nodiscard]] LawPoint withTail(LawPoint point) const noexcept;

    AttractiveTail tail_;
    AdhesionSplit split_;
    MaugisLaw zone_;
};

}  // namespace asperity
